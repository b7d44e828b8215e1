// Threads.
// must: drawn
// outside: through
static void *wait_long(void *context) {
    sleep(1);
    return context;
}

static void attack(const Frame *frame) {
    (void)frame;
    pthread_t thread;
    int count = 0;
    while (count < 100 && pthread_create(&thread, NULL, wait_long, NULL) == 0)
        count++;
    DENIED(count > 0);
}
