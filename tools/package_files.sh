#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# What packages hold beside the program, made from it: package_files.sh PROGRAM OUT. OUT/man1 (help2man), OUT/ghostlight.bash (completion),
# OUT/copyright (ours, and of what is compiled into the program). The same program and SOURCE_DATE_EPOCH give the same bytes.
set -euo pipefail
program=$(readlink -f "$1")
out=$2
here=$(dirname "$(readlink -f "$0")")/..
rm -rf "$out"
mkdir -p "$out/man1" "$out/bin"
ln -s "$program" "$out/bin/ghostlight" # its name in the pages
PATH=$out/bin:$PATH
export LC_ALL=C.UTF-8

commands=$(ghostlight --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\).*/\1/p')
words_of() { ghostlight "$1" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\).*/\1/p' | tr '\n' ' '; }
options_of() { ghostlight "$@" --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr ',' '\n' | sort -u | tr '\n' ' '; }

page() { # NAME SUMMARY WORD...
    help2man --no-info --no-discard-stderr --section=1 --version-string="$(ghostlight --version)" --name="$2" --output="$out/man1/$1.1" "${*:3}"
    gzip -9n "$out/man1/$1.1"
}
page ghostlight "stage lighting visualiser driven by a real desk" ghostlight
for command in $commands; do
    summary=$(ghostlight --help | sed -n "/^Subcommands:/,\$s/^  $command  *//p" | head -1)
    page "ghostlight-$command" "${summary:-a command of ghostlight}" ghostlight "$command"
done

{
    echo '# SPDX-License-Identifier: Apache-2.0'
    echo '# Completion of ghostlight in bash: commands, their options, files.'
    echo '_ghostlight() {'
    echo '    local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]:-} words= own=none'
    echo '    if [ "$COMP_CWORD" = 1 ]; then'
    echo "        words=\"$(echo $commands) $(options_of)\""
    echo '    else'
    echo '        case $command in'
    for command in $commands; do
        own=$(words_of "$command")
        options=$(options_of "$command")
        for one in $own; do options+=$(options_of "$command" "$one"); done
        echo "        $command) words=\"$(tr ' ' '\n' <<<"$options" | sort -u | tr '\n' ' ')\" own=\"$own\" ;;"
    done
    echo '        esac'
    echo '        [ "$COMP_CWORD" != 2 ] || [ -z "$own" ] || [[ $word == -* ]] || words=$own'
    echo '    fi'
    echo '    if [ "$COMP_CWORD" = 1 ] || [[ $word == -* ]] || [ "$words" = "$own" ]; then'
    echo '        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")'
    echo '    else'
    echo '        compopt -o filenames 2>/dev/null'
    echo '        mapfile -t COMPREPLY < <(compgen -f -- "$word")'
    echo '    fi'
    echo '}'
    echo 'complete -F _ghostlight ghostlight'
} >"$out/ghostlight.bash"

{
    echo 'Ghostlight is under the Apache License 2.0 (on Debian: /usr/share/common-licenses/Apache-2.0), its demo and fixture files, too.'
    echo 'VARI*LITE and VL2500 are marks of their owners, who have no part in this.'
    echo 'Compiled into the program are the following libraries, under the licences that Debian gives of them.'
    for package in libcli11-dev libglm-dev libtomlplusplus-dev nlohmann-json3-dev; do
        printf '\n==== %s ====\n\n' "$package"
        cat "/usr/share/doc/$package/copyright"
    done
} >"$out/copyright"
rm -r "$out/bin"
