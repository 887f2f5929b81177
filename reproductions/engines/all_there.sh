#!/bin/bash
# all_there.sh LOGS: whether the tasks made all files of LOGS/missing.txt. Asks for a minute, since a shared file system may show the last
# ones late.
tries=0
while true; do
    missing=
    while read -r file; do [ "$file" -nt "$1/missing.txt" ] || missing=$file; done < "$1/missing.txt"
    [ -n "$missing" ] || exit 0
    tries=$((tries + 1))
    [ $tries -lt 12 ] || exit 1
    sleep 5
done
