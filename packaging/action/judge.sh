#!/usr/bin/env bash
# Asks whether the renderer keeps the contract, judges, and tells the verdict; or puts shards together:
#   ZPROOF_SCENES=room ZPROOF_RENDERER='./mine {scene} {camera} {out}' judge.sh
#   MERGE='shard-1 shard-2' judge.sh
# Scenes, renderer, promise, shard and folder are zproof's own variables (docs/gate.md). Besides:
#   ARGUMENTS       further arguments of zproof run or merge, quoted as for a shell; nothing in them is expanded
#   CONTRACT_CHECK  false: not asked first
#   MERGE           folders of shards
# Ends with zproof's status, but for a shard: 1 (defects) and 4 (no scene in it) are for the merged run to tell.
# Appends verdict, report and status to $GITHUB_OUTPUT where that is set.
set -uo pipefail
export ZPROOF_OUT=${ZPROOF_OUT:-zproof-out}
export ZPROOF_REPORT=html,json,junit,github

# words TEXT NAME: the words of TEXT, as a shell would part them, into the array NAME.
words() {
    local text
    local -n list=$2
    text=$(xargs -r printf '%s\n' <<<"$1") || tell usage 2  # xargs has said why
    list=()
    [ -z "$text" ] || mapfile -t list <<<"$text"
}

# What a status of zproof means, in a word (docs/cli.md).
verdict_of() {
    case $1 in
        0) echo proven ;;
        1) echo defective ;;
        2) echo usage ;;
        3) if grep -qs '"undecided": [1-9]' "$ZPROOF_OUT/results.json"; then echo undecided; else echo unreadable; fi ;;
        4) echo nothing_judged ;;
        130) echo interrupted ;;
        *) echo internal_error ;;
    esac
}

tell() {
    local report=
    [ -f "$ZPROOF_OUT/results.json" ] && report=$ZPROOF_OUT
    printf '%s\n' "verdict=$1" "report=$report" "status=$2" >>"${GITHUB_OUTPUT:-/dev/null}"
    exit "$2"
}

# A renderer that is known by name keeps the contract.
check_contract() {
    [[ ${ZPROOF_RENDERER:-} == *{*}* && ${CONTRACT_CHECK:-true} == true ]] || return 0
    local promise=()
    [ -n "${ZPROOF_PRECISION:-}" ] && promise=(--precision "$ZPROOF_PRECISION")
    zproof contract-check "$ZPROOF_RENDERER" "${promise[@]}" && return
    local status=$?
    echo "::error title=zproof::the renderer does not keep the contract; the log of this step says where"
    tell contract_broken $status
}

words "${ARGUMENTS:-}" arguments
if [ -n "${MERGE:-}" ]; then
    words "$MERGE" shards
    zproof merge "${shards[@]}" "${arguments[@]}"
    status=$?
else
    check_contract
    zproof run "${arguments[@]}"
    status=$?
fi
verdict=$(verdict_of $status)
case ${ZPROOF_SHARD:+shard}$status in shard1 | shard4) status=0 ;; esac
tell "$verdict" $status
