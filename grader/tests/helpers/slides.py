#!/usr/bin/env python3
"""slides.py PAGE: holds grader/site/slides.md against the rubrics and the handouts. Prints each row that names a lab, a task or a
heading that is not there or has no place at all, each count that is wrong, and each lab that no row names; ends with 1 if any is."""
import json, pathlib, re, sys

page = pathlib.Path(sys.argv[1])
home = pathlib.Path("grader/site")  # links lead from where the page belongs, so that a copy of it can be tried
wrong = 0


def say(*words):
    global wrong
    wrong += 1
    print(*words)


def anchors(file):
    return {re.sub(r"[^a-z0-9]+", "-", line.lstrip("# ").lower()).strip("-") for line in file.read_text().splitlines() if line.startswith("## ")}


def tasks(lab):
    return {check["task"] for check in json.loads(pathlib.Path("solutions", lab, "rubric.json").read_text())["checks"]}


def look_at_link(words, target):
    path, _, anchor = target.partition("#")
    file = (pathlib.Path.cwd() / home / path).resolve()
    if not file.is_file():
        return say(f"[{words}] leads to {path}, which is not there")
    if anchor and anchor not in anchors(file):
        say(f"[{words}] leads to the heading {anchor}, which {path} has not")
    lab = file.parent.name
    if number := re.match(r"(\d+)\.\d+$", words):
        if not lab.startswith(f"{int(number[1]):02d}-"):
            say(f"the task {words} is not of {lab}")
        elif words not in tasks(lab):
            say(f"no check of {lab} is about task {words}")
    elif (number := re.match(r"(\d\d) ", words)) and not lab.startswith(number[1] + "-"):
        say(f"[{words}] leads to {lab}")
    named.add(lab)


named, counts, said, lecture = set(), {}, {}, None
for line in page.read_text().splitlines():
    if line.startswith("## "):
        lecture = line[3:]
    cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("| ") else []
    if len(cells) != 4 or cells[0] in ("lecture", "slide"):
        continue
    if lecture is None:
        said[cells[0]] = [int(cell) for cell in cells[1:]]
        continue
    links = [re.findall(r"\[([^]]+)\]\(([^)]+)\)", cell) for cell in cells]
    for link in links[2] + links[3]:
        look_at_link(*link)
    if not links[2]:
        say(f'"{cells[1]}" is taught nowhere')
    if bool(links[3]) == (cells[3] == "handout") or not all(re.match(r"\d+\.\d+$", words) for words, _ in links[3]):
        say(f'"{cells[1]}" is graded by "{cells[3]}": write tasks, or handout')
    count = counts.setdefault(lecture, [0, 0, 0])
    count[0] += 1
    count[1 if links[3] else 2] += 1
counts["all"] = [sum(column) for column in zip(*counts.values())] or [0, 0, 0]
for name in counts.keys() | said.keys():
    if counts.get(name) != said.get(name):
        say(f"{name}: the page says {said.get(name)}, and there are {counts.get(name)}")
for lab in sorted(file.parent.name for file in pathlib.Path("solutions").glob("*/rubric.json")):
    beyond = "goes beyond the lectures" in " ".join((pathlib.Path("solutions") / lab / "README.md").read_text().split())
    if lab not in named and not beyond:
        say(f"no row names {lab}")
print(counts["all"][0], "concepts", counts["all"][1], "graded")
sys.exit(wrong > 0)
