#!/usr/bin/env bash
# "Where is my slide?": each lab, task and heading that it names is there, its counts are right, and wrong ones are refused.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
page=grader/site/slides.md
look() { status=0; out=$(python3 grader/tests/helpers/slides.py "$1" 2>&1) || status=$?; }
look $page
expect "the page" 0 " concepts "

# refuses NAME SED PATTERN: a copy of the page with this edit is refused with these words.
refuses() {
    sed -E "$2" $page >"$work/slides.md"
    if cmp -s $page "$work/slides.md"; then bad "$1: the edit changes nothing"; return; fi
    look "$work/slides.md"
    expect "$1" 1 "$3"
}
refuses "a task that is not there" 's/\[3\.5\]/[3.9]/' "no check of 03-shadow-map is about task 3.9"
refuses "a task of another lab" 's/\[3\.5\]/[4.1]/' "the task 4.1 is not of 03-shadow-map"
refuses "a lab that is not there" 's/13-light-volumes/14-light-volumes/' "14-light-volumes/README.md, which is not there"
refuses "a lab under another number" 's/\[10 Words\]/[11 Words]/' "[11 Words] leads to 10-planar-shadows"
refuses "a heading that is not there" 's/#words/#the-words/' "leads to the heading the-words"
refuses "a concept without a place" 's/\| \[10 Words\][^|]*\|/| |/' "is taught nowhere"
refuses "no word on the grading" 's/\| handout \|/| |/' "write tasks, or handout"
refuses "a heading in place of a task" 's/\| handout \|$/| [10 Words](..\/..\/labs\/10-planar-shadows\/README.md#words) |/' "write tasks, or handout"
refuses "a row that is gone" '/`glFlush`/d' "the page says"
refuses "a wrong count" 's/^\| all \| [0-9]+/| all | 1/' "all: the page says [1,"
refuses "a lab that nobody names" 's/^.*13-light-volumes.*$//' "no row names 13-light-volumes"
finish
