# SPDX-License-Identifier: MIT
# The pencil draws on paper of each kind.
. "$ROOT/tests/check.sh"
example a.svg

draws "no --paper" -o default.png a.svg
draws "--paper medium" --paper medium -o medium.png a.svg
same "medium is the default paper" medium.png default.png
for paper in smooth rough none; do
    draws "--paper $paper" --paper $paper -o $paper.png a.svg
    differ "--paper $paper draws another grain" $paper.png default.png
done
draws "--model hla --paper rough" --model hla --paper rough -o hla-rough.png a.svg
draws "--model hla" --model hla -o hla.png a.svg
same "paper is not part of the papers' model" hla-rough.png hla.png
misused "--paper of another name" paper --paper silk a.svg
misused "--paper without an argument" paper --paper
