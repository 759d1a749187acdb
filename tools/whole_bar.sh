# SPDX-License-Identifier: Apache-2.0
# One bar with the time left over several commands: packages, compiler, pictures. Sourced by ./dev. Their own words go
# into a log, whose end is shown where one fails.
#   expect_s=470 log=FILE   what all parts take together on two quiet cores; only their ratios count
#   part 120 COMMAND...     a part and its share of that
expect_s=0
done_s=0
whole_begun_s=$SECONDS

clock_text() { printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); }

# show_whole PER_MILLE_OF_THE_PART SECONDS_OF_THE_PART WHAT
show_whole() {
    local elapsed_s=$((SECONDS - whole_begun_s)) width=24 filled line
    local per_mille=$(((1000 * done_s + $1 * $2) / (expect_s > 0 ? expect_s : 1)))
    [ "$per_mille" -le 1000 ] || per_mille=1000
    filled=$((per_mille * width / 1000))
    line=$(printf 'demo %3d %% [%-*s]' $((per_mille / 10)) $width "$(printf '%*s' $filled '' | tr ' ' '#')")
    [ "$per_mille" -lt 10 ] || line+=" $(clock_text $((elapsed_s * (1000 - per_mille) / per_mille))) left"
    line+="  $3"
    if [ -t 2 ]; then
        printf '\r%-79.79s' "$line" >&2
    elif [ "$elapsed_s" -ge "${next_line_s:-0}" ]; then
        next_line_s=$((elapsed_s + 10))
        printf '%s\n' "$line" >&2
    fi
}

# Reads how far a command is from what it says: apt's status lines, ninja's [3/400], our own "42 % [####".
follow_part() {
    local part_s=$1 line per_mille=0 what=
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$log"
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*) ]]; then
            per_mille=$((1000 * BASH_REMATCH[1] / BASH_REMATCH[2]))
            what=${BASH_REMATCH[3]##* }
            [[ $what != */ghost_*/Unity/* ]] || { what=${what#*/ghost_} && what=${what%%.dir/*}; } # a room, whole
            what="compiling ${what##*/}"
        elif [[ $line =~ ^dlstatus:[^:]*:([0-9]+) ]]; then
            per_mille=$((3 * BASH_REMATCH[1]))
            what="fetching packages"
        elif [[ $line =~ ^pmstatus:([^:]*):([0-9]+) ]]; then
            per_mille=$((300 + 7 * BASH_REMATCH[2]))
            what="unpacking ${BASH_REMATCH[1]}"
        elif [[ $line =~ ([0-9]+)\ %\ \[ ]]; then
            per_mille=$((10 * BASH_REMATCH[1]))
            what=${line%% *}
        fi
        show_whole "$per_mille" "$part_s" "$what"
    done
}

part() {
    local part_s=$1
    shift
    mkdir -p "$(dirname "$log")"
    if ! "$@" 2>&1 | follow_part "$part_s"; then
        printf '\n' >&2
        tail -n 30 "$log" | grep -v '^[dp][lm]status:' >&2
        echo "failed: $*; all it said is in $log" >&2
        return 1
    fi
    done_s=$((done_s + part_s))
}
