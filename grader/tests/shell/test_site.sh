#!/usr/bin/env bash
# The course site: every link leads somewhere, every formula is MathML, the pages are accessible, wrong input is refused.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
browser=grader/tests/browser
for tool in node npm cmark-gfm chromium; do
    command -v $tool >/dev/null || { skip "there is no $tool (common/setup --test)"; finish; exit; }
done
runs() { status=0; out=$("$@" 2>&1) || status=$?; }
runs flock $browser/package.json make --no-print-directory BUILD="$work" grader/site/node_modules/.package-lock.json $browser/node_modules/.package-lock.json
expect "npm" 0
site="$work/a site, 100 % of #1 & ß?" # pages are files, and lie where a student puts them
export SHADOW_LAB_PROGRESS=$work/progress.json
cat >"$SHADOW_LAB_PROGRESS" <<'END'
{"version": 1, "labs": {
 "03": {"score": 100, "max_score": 100, "best": 100, "done": true, "done_on": "2026-11-20"},
 "05": {"score": 99.99, "max_score": 100, "best": 99.99, "done": false, "done_on": "<b>"},
 "07": {"score": 0, "max_score": 100, "best": 0, "done": false}, "09": 5, "x": {"best": 1}, "99": {"score": "many"}}}
END
runs node grader/site/build.mjs "$site"
labs=(labs/[0-9][0-9]-*[a-z]) rooms=(grader/*/*.md)
expect "the site is built" 0 "$((8 + ${#labs[@]} + ${#rooms[@]})) pages"
out=$(cat "$site/index.html")
expect "the progress" 0 "✓ done on 2026-11-20" "99 of 100 points" "1 of ${#labs[@]} labs done, 199 points" 'next is <a href="01-subroutines.html">'
[[ $out != *"<b>"* && $(grep -o 'class="done"' "$site/01-subroutines.html" | wc -l) == 1 ]] && ok || bad "what is not done is not marked"

# An eye of its own, with Python's parser: what is counted here is not what the site's builder counted.
cat >"$work/look.py" <<'PYTHON'
import html.parser, pathlib, re, sys, urllib.parse
class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.ids, self.links, self.text, self.stack, self.math, self.next = set(), [], "", [], 0, None
        self.feed(file.read_text())
    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        self.ids.add(a.get("id"))
        self.links += [a[k] for k in ("href", "src") if k in a]
        self.math += tag == "math"
        if a.get("rel") == "next": self.next = a["href"]
        if tag not in ("img", "meta", "br", "hr", "link"): self.stack.append(tag)
    def handle_endtag(self, tag):
        if tag in self.stack:
            while self.stack.pop() != tag: pass
    def handle_data(self, data):
        if not {"code", "pre", "annotation", "style", "script"} & set(self.stack): self.text += data
site = pathlib.Path(sys.argv[1])
pages = {f.name: Page(f) for f in site.glob("*.html")}
wrong = 0
def say(*words):
    global wrong
    wrong += 1
    print(*words)
for name, page in pages.items():
    for link in page.links:
        if re.match(r"https?:|data:", link): continue
        path, _, anchor = link.partition("#")
        target = urllib.parse.unquote(path) or name
        if not (site / target).is_file(): say(name, "links to", link, "which is not there")
        elif anchor and anchor not in pages[target].ids: say(name, "links to", link, "whose anchor is not there")
    if "$" in page.text: say(name, "shows a raw $:", page.text[max(0, page.text.index("$") - 40):][:90])
    if "xFORMULAx" in page.text or "katex-error" in (site / name).read_text(): say(name, "has a formula that failed")
for source in sys.argv[2:]:
    text = re.sub(r"(?ms)^```.*?^```", "", pathlib.Path(source).read_text())
    text = re.sub(r"(?m)^ {4}.*$", "", re.sub(r"`[^`]+`", "", text))
    count = len(re.findall(r"(?s)\$\$.+?\$\$|\$[^$]+\$", text))
    parts = source.split("/")
    room = "-".join(part.lower().removesuffix(".md") for part in parts if part != "README.md")
    name = {"README.md": "students", "common/DEBUGGING.md": "debugging", ".github/CONTRIBUTING.md": "contributing", "grader/site/slides.md": "slides"}.get(source)
    name = (name or (room if parts[0] == "grader" else parts[-2])) + ".html"
    math = pages[name].math + (pages["teachers.html"].math + pages["index.html"].math if source == "README.md" else 0)
    if math != count: say(name, "has", math, "formulas,", source, "has", count)
name, way = "index.html", []
while name: way.append(name); name = pages[name].next
if way != ["index.html", "students.html", *sorted(n for n in pages if n[0].isdigit()), "wrong.html", "slides.html", "debugging.html", "search.html", "teachers.html", "contributing.html", "grader.html", *sorted((n for n in pages if n.startswith("grader-")), key=lambda n: n[:-5])]: say("the way through the lectures is", way)
if "slides.html" not in pages["index.html"].links: say("index.html has no link to slides.html")
print(len(pages), "pages", sum(p.math for p in pages.values()), "formulas")
sys.exit(wrong > 0)
PYTHON
# No page holds an answer to a handout's question: they are told when the lab is done.
cat >"$work/answers.py" <<'PYTHON'
import html, json, pathlib, re, sys
bare = lambda text: re.sub(r"\W+", "", text)
pages = {page.name: bare(html.unescape(re.sub("<[^>]*>", "", page.read_text()))) for page in pathlib.Path(sys.argv[1]).glob("*.html")}
parts = [part for file in sys.argv[2:] for question in json.load(open(file))["questions"] for part in question["answer"]]
told = [f"{name}: {part[:60]}" for name, page in pages.items() for part in parts if bare(part)[:40] in page]
print(*told, f"{len(parts)} parts of answers, {len(told)} told", sep="\n")
sys.exit(bool(told) or not parts)
PYTHON
answers() { runs python3 "$work/answers.py" "$1" solutions/*/afterword.json; }
answers "$site"
expect "no answer on a page" 0 " 0 told"
mkdir "$work/telling"
python3 -c 'import html, json; print("<p>" + html.escape(json.load(open("'solutions/04-acne-and-bias/afterword.json'"))["questions"][2]["answer"][0]) + "</p>")' >"$work/telling/a.html"
answers "$work/telling"
expect "an answer on a page is seen" 1 "a.html: The point stands" " 1 told"

look() { runs python3 "$work/look.py" "$site" "${sources[@]}"; }
sources=(README.md labs/[0-9][0-9]-*[!0-9]/README.md common/DEBUGGING.md .github/CONTRIBUTING.md grader/README.md "${rooms[@]}")
look
expect "links, formulas, the way through" 0 " formulas"
grep -qE '[1-9][0-9]+ formulas' <<<"$out" && ok || bad "there are formulas" "$out"

# In a browser: all pages (but only one listing).
mapfile -t shown < <(ls "$site"/*.html | grep -v /file-; ls "$site"/file-*.html | head -1)
runs node $browser/audit.mjs "${shown[@]}"
expect "nothing wrong in a browser" 0
browses course.mjs "$site"

# The checkers see what is wrong.
cp -r "$site" "$work/kept"
sed -i 's/href="02-framebuffers.html"/href="02-nothing.html"/; s/<h2/<p>a raw $ sign<\/p><h2/; 0,/<math/s/<math/<span/' "$site/03-shadow-map.html"
rm "$site/pictures/03-shadow-map/map.png"
look
expect "a damaged site" 1 "links to 02-nothing.html" "links to pictures/03-shadow-map/map.png" "a raw $" "03-shadow-map.html has"
sed -i 's/<h2/<img src="none.png"><button><\/button><h2/' "$site/04-acne-and-bias.html"
runs node $browser/audit.mjs "$site/04-acne-and-bias.html"
expect "a page that is not accessible" 1 "broken picture" "axe image-alt" "axe button-name"

# The builder refuses what it cannot show, and leaves code alone.
copy=$work/copy
mkdir "$copy"
cp -r README.md LICENSE .github common shaders labs solutions grader "$copy"
cd "$copy" || exit 1
page=labs/03-shadow-map/README.md
cp $page "$work/page"
printf '\n$\\frac{1}$\n' >>$page
runs node grader/site/build.mjs "$work/none"
expect "a wrong formula" 1 "$page: the formula" "is wrong"
{ cat "$work/page"; printf '\n[where?](nowhere.md)\n'; } >$page
runs node grader/site/build.mjs "$work/none"
expect "a link that leads nowhere" 1 "$page: the link to nowhere.md leads nowhere"
# A progress that is damaged is said, and keeps nobody from the pages.
cp "$work/page" $page
for text in '{' '[]' '{"labs": 3}' 'null'; do echo "$text" >"$SHADOW_LAB_PROGRESS" && runs node --input-type=module -e 'import { progress } from "./grader/site/progress.mjs"; console.log(progress().size)'
    expect "a progress like $text" 0 "progress.json is damaged" "0"
done
# What was measured is linked from the labs' pages, where it is there.
mkdir -p build/study
printf '%s\n' 'const scenes = [{"name":"disc","title":"A disc & more","points":[{"lab":"03"},{"lab":"06"}]},' '{"name":"eye","title":"An eye","points":[{"lab":"07"}]}' '];' >build/study/chart.html
printf '<section id="row-%s"><h2>%s. %s <span>' 17 17 'early-out' 9 9 'light &lt; dark' 302 302 'far &amp; wide' 1001 1001 wide >build/study/stability.html
runs node grader/site/build.mjs "$work/measured"
expect "with what was measured, and without progress" 0 "progress.json is damaged"
grep -q 'class="progress"' "$work/measured/index.html" && bad "a progress that cannot be read" || ok
links() { grep -o 'href="measured/[^<]*' "$work/measured/$1"*.html | sed 's/.*href=//'; }
[[ $(links 03) == *'chart.html#disc">Speed against error: A disc &amp; more'*'stability.html#row-9">Where methods break: light &lt; dark'*'#row-302">'* && $(links 03) != *1001* ]] && ok || bad "links of lab 03" "$(links 03)"
[[ $(links 06) == *'chart.html#disc'*'#row-17">'* && $(links 06) != *'#eye'* && $(links 07) == *'chart.html#eye'* ]] && ok || bad "links of labs 06, 07" "$(links 06; links 07)"
[[ $(links 10) == *'#row-1001">'* && -z $(links 01) && -s $work/measured/measured/stability.html ]] && ok || bad "links of others" "$(links 10; links 01)"
rm -r build
printf '\n[where?](nowhere.md)\n' >>$page
mv solutions elsewhere
runs node grader/site/build.mjs "$work/none"
expect "the same in a kit, which lacks some files" 0 "pages"
mv elsewhere solutions
{ cat "$work/page"; printf '\nPay $5 or `$HOME$`, `` `$x$` ``: $a_1 * b_2 * c$ and 6$.\n\n```sh\necho $1 $2\n```\n\n    set $HOME$ aside\n\n| $|x|$ | b |\n|---|---|\n| $y$ | $|z|$ |\n'; } >$page
runs node grader/site/build.mjs "$work/none"
expect "dollars in code and prose" 0
out=$(tail -120 "$work/none/03-shadow-map.html" | sed 's/<span class="hljs[^>]*>\([^<]*\)<\/span>/\1/g') # without colours
for text in '<code>$HOME$</code>' '<code>`$x$`</code>' 'echo $1 $2' 'set $HOME$ aside' 'Pay $5' 'and 6$.' '<annotation encoding="application/x-tex">a_1 * b_2 * c</annotation>' '>|z|</annotation>'; do
    grep -qF -- "$text" <<<"$out" && ok || bad "no $text" "$out"
done
# A handout like no other: no picture, no diagram, lines of code and formulas that are wider than a phone, a long word, a long table.
long=$(printf 'a_%.0s' {1..120}) terms=$(printf 'a_{%s} + ' {1..60})
grep -v '^!\[' "$work/page" >$page
printf '\n## What goes wrong elsewhere\n\n`%s` %s\n\n```c\nint %s = 0;\n```\n\n$%s b$ and\n\n$$%s b$$\n\n| %s |\n|---|\n| `%s` |\n\n![Wrong | odd "quotes"](wrong-w.png) ![Right](picture.png)\n' "$long" "${long//_/}" "$long" "$terms" "$terms" "$(printf 'column | %.0s' {1..30})" "$long" >>$page
echo >"$SHADOW_LAB_PROGRESS"
runs node grader/site/build.mjs "$work/none"
expect "an odd handout" 0 "pages"
runs node "$root/$browser/audit.mjs" "$work"/none/{index,03-shadow-map,wrong}.html
expect "is right in a browser" 0
finish
