"""Pages that scripts write: shell.html filled, and the file is there as a whole or not at all.

Who imports this has what the machine refuses, and Ctrl-C, told in one line without a traceback.
"""
import os, pathlib, re, sys

HERE = pathlib.Path(__file__).parent


def _tell(kind, error, trace):
    if issubclass(kind, KeyboardInterrupt):
        print("stopped; nothing was written", file=sys.stderr)
    elif issubclass(kind, OSError):
        print(f"{error.filename or 'a file'}: {error.strerror}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


sys.excepthook = _tell


def write(path, title, style, content):
    """Writes a page whose pictures are in it; `style` is CSS behind base.css, `content` HTML. Returns its length."""
    holes = {"title": title, "policy": "img-src data:", "style": (HERE / "base.css").read_text() + style, "content": content}
    page = re.sub(r"{{(\w+)}}", lambda hole: holes[hole[1]], (HERE / "shell.html").read_text())
    new = pathlib.Path(f"{path}.new")
    try:
        new.write_text(page, encoding="utf-8")
        os.replace(new, path)
    except OSError as error:
        new.unlink(missing_ok=True)
        sys.exit(f"{path} cannot be written: {error.strerror}")
    return len(page)
