#!/usr/bin/env bash
# Starting inputs for the fuzz targets: bash tests/fuzz/seeds.sh FOLDER [PLAN]
#
# Writes FOLDER/parser_fuzzer, FOLDER/sas_fuzzer and FOLDER/plan_fuzzer; PLAN is the command (build/bin/plan).
set -euo pipefail
folder=$(realpath -m "$1")
plan=$(realpath "${2:-build/bin/plan}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p "$folder"/{parser,sas,plan}_fuzzer

for domain in domains/*/domain.pddl; do
    name=$(basename "$(dirname "$domain")")
    problem=problems/$name/small.pddl
    { cat "$domain" && printf '\f' && cat "$problem"; } >"$folder/parser_fuzzer/$name"
    "$plan" ground "$domain" "$problem" --sas "$folder/sas_fuzzer/$name" --quiet >/dev/null
done
printf '(go e a b)\n(toggle b)\n(go f d a)\n(clear)\n; cost = 11/6 (general cost)\n' >"$folder/plan_fuzzer/steps"
printf '0.0: (TOGGLE B) [1.000]\n2: (clear) ; not yet\n' >"$folder/plan_fuzzer/timed"
