#!/bin/bash
# check_pages.sh PAGE.html...: opens each page in headless Chromium as wide as a phone (390 px) and a desk (1280 px). Fails if
# anything reaches beyond the width of the page, an image does not load, or a link to a file leads nowhere.
set -eu
scratch=$(mktemp -d) failed=0
trap 'rm -rf "$scratch"' EXIT
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
    { echo "chromium is not installed (pages are looked at in it). Install the package chromium?"; exit 1; }

# The page in a frame of the wanted width; what is wrong is written into the frame's host, which --dump-dom prints.
look() { # page width
    cat > "$scratch/host.html" <<HOST
<body style="margin:0"><iframe id="page" style="border:0;width:${2}px;height:900px" src="file://$1"></iframe><pre id="said">unread</pre><script>
page.onload = () => setTimeout(() => {
  const view = page.contentWindow, page_document = page.contentDocument, said = [];
  if (page_document.documentElement.scrollWidth > $2) {
    said.push("wider than $2 px: " + page_document.documentElement.scrollWidth);
    for (const e of page_document.querySelectorAll("body *")) {
      if (e.getBoundingClientRect().right > $2 + 1 && !e.closest(".table")) { said.push("  " + e.tagName + "." + e.className + " #" + e.id); break; }
    }
  }
  for (const image of page_document.images) if (!image.complete || image.naturalWidth == 0) said.push("no image: " + image.alt);
  for (const svg of page_document.querySelectorAll("figure svg")) if (svg.getBoundingClientRect().height < 50) said.push("flat figure: " + svg.id);
  const figures = page_document.querySelectorAll("figure").length;
  document.getElementById("said").textContent = said.length ? said.join("; ") : "fine, " + figures + " figures";
}, 500);
</script></body>
HOST
    "$browser" --headless --no-sandbox --disable-gpu --allow-file-access-from-files --virtual-time-budget=8000 --dump-dom \
        --user-data-dir="$scratch/profile" "file://$scratch/host.html" 2> /dev/null | sed -n 's/.*<pre id="said">\(.*\)<\/pre>.*/\1/p'
}

for page in "$@"; do
    page=$(realpath "$page")
    for width in 390 1280; do
        said=$(look "$page" $width)
        echo "$page at $width px: $said"
        case $said in fine*) ;; *) failed=1 ;; esac
    done
    while read -r link; do
        [ -e "$(dirname "$page")/$link" ] || { echo "$page: the link $link leads nowhere"; failed=1; }
    done < <(grep -o 'href="[^"#:]*"' "$page" | sed 's/href="//; s/"//' | sort -u)
done
exit $failed
