#!/bin/sh
# ledger.sh CHECKS.csv...: every statement with its verdict as one page of Markdown, on the standard output.
set -eu
[ -e "$1" ] || { echo "there is no checks.csv yet (no chapter has been reproduced). Run make reproduce-chapter3?" >&2; exit 2; }
echo "# All statements and their verdicts"
echo
# Quoted cells may hold commas: split by hand.
awk '
    function cells(line, c,   n, k, ch, quoted) {
        n = 1; c[1] = ""; quoted = 0
        for (k = 1; k <= length(line); ++k) {
            ch = substr(line, k, 1)
            if (ch == "\"") quoted = !quoted
            else if (ch == "," && !quoted) c[++n] = ""
            else c[n] = c[n] ch
        }
        return n
    }
    FNR == 1 { n = cells($0, head); for (k = 1; k <= n; ++k) at[head[k]] = k; next }
    {
        split("", c); cells($0, c)
        verdict = c[at["verdict"]]; chapter = c[at["chapter"]]
        ++count[chapter, verdict]; ++all[verdict]; ++rows; if (!(chapter in seen)) { seen[chapter] = ++chapters; name[chapters] = chapter }
        line[rows] = sprintf("| %s | %s | %s | %s | %s | %s | **%s** |", c[at["id"]], chapter, c[at["quantity"]], c[at["condition"]], \
            c[at["reference"]], c[at["computed"]], verdict)
    }
    END {
        split("match unresolved differs-explained not-reproduced not-computable", v, " ")
        print "| chapter | match | unresolved | differs, explained | not reproduced | not computable |"
        print "|---|---|---|---|---|---|"
        for (n = 1; n <= chapters; ++n) {
            printf "| %s", name[n]; for (k = 1; k <= 5; ++k) printf " | %d", count[name[n], v[k]]; print " |"
        }
        printf "| all"; for (k = 1; k <= 5; ++k) printf " | %d", all[v[k]]; print " |\n"
        print "| id | chapter | quantity | condition | text | computed | verdict |"
        print "|---|---|---|---|---|---|---|"
        for (n = 1; n <= rows; ++n) print line[n]
    }' "$@"
