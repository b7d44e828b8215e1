// Which machine this is, and whose.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    struct utsname names, raw;
    char name[300] = "", domain[300] = "", host[300] = "";
    static const char *const files[] = {"/etc/hostname",
                                        "/etc/hosts",
                                        "/etc/machine-id",
                                        "/etc/resolv.conf",
                                        "/etc/timezone",
                                        "/etc/localtime",
                                        "/proc/sys/kernel/hostname",
                                        "/proc/sys/kernel/domainname",
                                        "/proc/version",
                                        "/proc/cpuinfo",
                                        "/proc/cmdline",
                                        "/proc/self/environ",
                                        "/proc/self/mountinfo",
                                        "/proc/1/environ",
                                        "/sys/class/dmi/id/product_name",
                                        "/var/log",
                                        "/run"};
    static const char *const variables[] = {"HOSTNAME",  "HOST",
                                            "USER",      "LOGNAME",
                                            "HOME",      "OLDPWD",
                                            "TZ",        "MAIL",
                                            "SUDO_USER", "SSH_CONNECTION",
                                            "DISPLAY",   "XDG_RUNTIME_DIR",
                                            "TMPDIR",    "DBUS_SESSION_BUS_ADDRESS"};
    snprintf(host, sizeof host, "%s", HOST);
    DENIED(uname(&names) == 0 && strcmp(names.nodename, host) == 0);
    DENIED(syscall(SYS_uname, &raw) == 0 && strcmp(raw.nodename, host) == 0);
    DENIED(gethostname(name, sizeof name) == 0 && strcmp(name, host) == 0);
    DENIED(uname(&names) == 0 && names.domainname[0]);
    DENIED(getdomainname(domain, sizeof domain) == 0 && domain[0]);
    for (unsigned i = 0; i < sizeof files / sizeof *files; i++)
        if (opens(files[i], O_RDONLY))
            check_fail("GOT THROUGH: %s can be read", files[i]);
    for (unsigned i = 0; i < sizeof variables / sizeof *variables; i++)
        if (getenv(variables[i]))
            check_fail("GOT THROUGH: the environment has %s", variables[i]);
}
