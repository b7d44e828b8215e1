// Sockets of every kind.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    int pair[2];
    struct sockaddr_in address = {
        .sin_family = AF_INET, .sin_port = htons(9), .sin_addr = {htonl(INADDR_LOOPBACK)}};
    DENIED(socket(AF_INET, SOCK_STREAM, 0) >= 0);
    DENIED(socket(AF_INET, SOCK_DGRAM, 0) >= 0);
    DENIED(socket(AF_INET6, SOCK_STREAM, 0) >= 0);
    DENIED(socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
    DENIED(socket(AF_NETLINK, SOCK_RAW, 0) >= 0);
    DENIED(socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0);
    DENIED(connect(0, (struct sockaddr *)&address, sizeof address) == 0);
}
