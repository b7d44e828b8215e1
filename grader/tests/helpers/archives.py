"""archives.py FOLDER: writes archives into it, good and hostile ones, by Python's own modules."""
import io
import pathlib
import sys
import tarfile
import zipfile

out = pathlib.Path(sys.argv[1])
LAB = b"int a;\n"


def make_zip(name, entries, compression=zipfile.ZIP_DEFLATED):
    with zipfile.ZipFile(out / name, "w", compression) as archive:
        for entry, data in entries:
            archive.writestr(entry, data)


def make_tar(name, members, mode="w:gz"):
    with tarfile.open(out / name, mode) as archive:
        for member, kind, value in members:
            info = tarfile.TarInfo(member)
            info.type = kind
            if kind == tarfile.REGTYPE:
                info.size = len(value)
                archive.addfile(info, io.BytesIO(value))
            else:
                info.linkname = value
                archive.addfile(info)


def unix(name, mode):
    info = zipfile.ZipInfo(name)
    info.create_system = 3
    info.external_attr = mode << 16
    return info


good = [("03-shadow-map/lab.c", LAB), ("03-shadow-map/shadow.frag", b"void main() {}\n"), ("notes \u00e9.txt", b"")]
make_zip("good.zip", good)
make_zip("stored.zip", good, zipfile.ZIP_STORED)
for suffix in ("gz", "xz", "bz2"):
    make_tar(f"good.tar.{suffix}", [("./" + n, tarfile.REGTYPE, d) for n, d in good], "w:" + suffix)
make_tar("good.tar", [("03-shadow-map", tarfile.DIRTYPE, "")] + [(n, tarfile.REGTYPE, d) for n, d in good], "w")

make_zip("up.zip", [("../up.c", LAB)])
make_zip("up-inside.zip", [("a/../../up.c", LAB)])
make_zip("absolute.zip", [("/tmp/shadow-lab-hostile.c", LAB)])
make_zip("dot.zip", [("a/./b.c", LAB)])
make_zip("control.zip", [("a\x1b[31m.c", LAB)])
make_zip("twice.zip", [("03-shadow-map/lab.c", b"other"), *good])
make_zip("file-and-folder.zip", [("lab.c", LAB), ("lab.c/lab.c", LAB)])
make_zip("symlink.zip", [(unix("lab.c", 0o120777), b"/etc/passwd")])
make_zip("through-link.zip", [(unix("a", 0o120777), b"/tmp"), ("a/shadow-lab-hostile.c", LAB)])
make_tar("symlink.tar.gz", [("lab.c", tarfile.SYMTYPE, "/etc/passwd")])
make_tar("hardlink.tar.gz", [("a", tarfile.REGTYPE, LAB), ("lab.c", tarfile.LNKTYPE, "a")])
make_tar("messages.zip", [("the archive cannot be read: No space left on device.c", tarfile.SYMTYPE, "there is not enough room")])
make_tar("fifo.tar.gz", [("lab.c", tarfile.FIFOTYPE, "")])
make_tar("device.tar.gz", [("lab.c", tarfile.CHRTYPE, "")])

make_zip("large-file.zip", [("bomb.c", bytes(17 << 20))])
make_zip("large-sum.zip", [(f"bomb{i}.c", bytes(15 << 20)) for i in range(5)])
make_zip("many.zip", [(f"{i}.c", b"") for i in range(4001)])
(out / "text.zip").write_bytes(b"this is no archive at all, but it is long enough to be looked at\n" * 20)
(out / "empty.zip").write_bytes(b"")
(out / "cut.zip").write_bytes((out / "good.tar.gz").read_bytes()[:120])
(out / "flipped.zip").write_bytes((out / "stored.zip").read_bytes().replace(LAB, b"int b;\n"))
