// The solution, the reference and everything else that can be read.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    DENIED(opens(ROOT "/solutions", O_RDONLY | O_DIRECTORY));
    DENIED(opens(ROOT "/solutions/03-shadow-map/lab.c", O_RDONLY));
    DENIED(opens(ROOT "/solutions/03-shadow-map/shadow.frag", O_RDONLY));
    DENIED(opens(ROOT "/build/cache", O_RDONLY | O_DIRECTORY));
    DENIED(opens(ROOT, O_RDONLY | O_DIRECTORY));
    DENIED(opens("../../../../../../.." ROOT "/solutions/03-shadow-map/lab.c", O_RDONLY));
    DENIED(opens(SECRET, O_RDONLY));
    char again[32];
    int known = open(SECRET, O_PATH);
    snprintf(again, sizeof again, "/proc/self/fd/%d", known);
    DENIED(known >= 0 && opens(again, O_RDONLY));
    DENIED(opens("/tmp", O_RDONLY | O_DIRECTORY));
    DENIED(opens("/etc/passwd", O_RDONLY));
    DENIED(opens("/proc/self/root" SECRET, O_RDONLY));
    char target[16];
    DENIED(readlink("/proc/self/exe", target, sizeof target) > 0 && opens("/proc/self/maps", O_RDONLY));
}
