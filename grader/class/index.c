// Writes the page's parts one after the other: the distribution of scores, the commonest mistakes, who needs
// a look, and all students.
#include "class/index.h"

#include "scene/check.h"
#include "base/statistics.h"
#include "pages/page.h"

#include <stdlib.h>
#include <string.h>

enum { BINS = 10, MAX_CAUSES = 512, SHOWN_CAUSES = 15 };

// A bar beside its number; `most` is as long as a bar gets.
static void bar_cell(Page *page, int value, int most) {
    fprintf(page->out, "<td class=\"number\">%d</td><td aria-hidden=\"true\">", value);
    if (value > 0)
        fprintf(page->out, "<span class=\"bar\" style=\"width:%.2frem\"></span>", 14.0 * value / most);
    fputs("</td>", page->out);
}

static void write_bins(Page *page, const char *lab, const int *bins) {
    char label[40];
    int most = 1;
    for (int b = 0; b <= BINS; b++)
        most = bins[b] > most ? bins[b] : most;
    snprintf(label, sizeof label, "Distribution of lab %s", lab);
    page_begin_table(page, label, (const char *const[]){"% of the points", "#submissions", "", NULL});
    for (int b = 0; b <= BINS; b++) {
        if (b < BINS)
            fprintf(page->out, "<tr><th scope=\"row\">%d to below %d</th>", 100 * b / BINS,
                    100 * (b + 1) / BINS);
        else
            fputs("<tr><th scope=\"row\">100</th>", page->out);
        bar_cell(page, bins[b], most);
        fputs("</tr>\n", page->out);
    }
    page_end_table(page);
}

static void write_distribution(Page *page, const Table *table, int n) {
    double *scores = calloc((size_t)table->roster->count, sizeof *scores), maximum = 0, sum = 0;
    int bins[BINS + 1] = {0}, count = 0, passed = 0;
    const char *name = "";
    INVARIANT(scores);
    for (int i = 0; i < table->roster->count; i++) {
        const json_t *lab = table_is_graded(table, i) ? table_lab(table, i, n) : NULL;
        if (!lab)
            continue;
        maximum = table_number(lab, "max_score");
        name = table_text(lab, "name");
        sum += scores[count++] = table_number(lab, "score");
        passed += strcmp(table_text(lab, "status"), "passed") == 0;
        bins[(int)(BINS * scores[count - 1] / maximum + 1e-9)]++;
    }
    if (count > 0) {
        fprintf(page->out, "<h3>Lab %s: ", table->plan->labs[n]);
        page_text(page, name);
        fprintf(page->out,
                "</h3>\n<p>%d of %d passed; of %.0f points the median is %.2f, the mean %.2f.</p>\n", passed,
                count, maximum, statistics_median(scores, (size_t)count), sum / count);
        write_bins(page, table->plan->labs[n], bins);
    }
    free(scores);
}

typedef struct Cause {
    const char *lab, *task, *kind;
    int submissions, last; // last: the entry that was counted last
} Cause;

typedef struct Causes {
    Cause list[MAX_CAUSES];
    int count;
} Causes;

static bool same_cause(const Cause *a, const Cause *b) {
    return strcmp(a->kind, b->kind) == 0 && strcmp(a->lab, b->lab) == 0;
}

static void count_cause(Causes *causes, const char *lab, const json_t *check, int entry) {
    const Cause cause = {lab, table_text(check, "task"), table_text(json_object_get(check, "cause"), "kind"),
                         0, -1};
    int i = 0;
    while (i < causes->count && !same_cause(&causes->list[i], &cause))
        i++;
    if (!cause.kind[0] || i == MAX_CAUSES)
        return;
    if (i == causes->count)
        causes->list[causes->count++] = cause;
    causes->list[i].submissions += causes->list[i].last != entry;
    causes->list[i].last = entry;
}

static int by_frequency(const void *a, const void *b) {
    const Cause *x = a, *y = b;
    if (x->submissions != y->submissions)
        return y->submissions - x->submissions;
    int lab = strcmp(x->lab, y->lab);
    return lab ? lab : strcmp(x->kind, y->kind);
}

static void count_causes(Causes *causes, const Table *table) {
    size_t c;
    json_t *check;
    causes->count = 0;
    for (int i = 0; i < table->roster->count; i++)
        for (int n = 0; n < table->plan->lab_count; n++)
            json_array_foreach(json_object_get(table_lab(table, i, n), "checks"), c, check)
                count_cause(causes, table->plan->labs[n], check, i);
    qsort(causes->list, (size_t)causes->count, sizeof causes->list[0], by_frequency);
}

static void write_causes(Page *page, const Table *table) {
    static Causes causes;
    count_causes(&causes, table);
    fputs("<h2>The commonest mistakes</h2>\n", page->out);
    if (causes.count == 0) {
        fputs("<p>None.</p>\n", page->out);
        return;
    }
    page_begin_table(page, "The commonest mistakes",
                     (const char *const[]){"lab", "task", "mistake", "#submissions", "", NULL});
    for (int i = 0; i < causes.count && i < SHOWN_CAUSES; i++) {
        fputs("<tr>", page->out);
        page_cell(page, causes.list[i].lab);
        page_cell(page, causes.list[i].task);
        page_cell(page, causes.list[i].kind);
        bar_cell(page, causes.list[i].submissions, causes.list[0].submissions);
        fputs("</tr>\n", page->out);
    }
    page_end_table(page);
}

static void write_link(Page *page, const Table *table, int i) {
    const RosterEntry *entry = &table->roster->entries[i];
    if (table_is_graded(table, i))
        fprintf(page->out, "<a href=\"pages/%s.html\">", entry->file);
    page_text(page, entry->shown);
    if (table_is_graded(table, i))
        fputs("</a>", page->out);
}

static void look_row(Page *page, const Table *table, int i, const char *lab, const char *what,
                     const char *message) {
    char first[200];
    snprintf(first, sizeof first, "%s", message);
    for (char *end; (end = strchr(first, '\n'));)
        *end = ' ';
    fputs("<tr><td class=\"name\">", page->out);
    write_link(page, table, i);
    fputs("</td>", page->out);
    page_cell(page, lab);
    page_cell(page, what);
    page_cell(page, first);
    fputs("</tr>\n", page->out);
}

static bool needs_look(const Table *table, int i) {
    bool needs = !table_is_graded(table, i);
    for (int n = 0; !needs && n < table->plan->lab_count; n++)
        needs = table_text(table_lab(table, i, n), "message")[0] != '\0';
    return needs;
}

static void write_look_table(Page *page, const Table *table) {
    int count = 0;
    for (int i = 0; i < table->roster->count; i++)
        count += needs_look(table, i);
    if (count == 0) {
        fputs("<p>Nobody.</p>\n", page->out);
        return;
    }
    page_begin_table(page, "Who needs a look",
                     (const char *const[]){"submission", "lab", "status", "message", NULL});
    for (int i = 0; i < table->roster->count; i++) {
        if (!table_is_graded(table, i))
            look_row(page, table, i, "all", "not graded", table_reason(table, i));
        for (int n = 0; table_is_graded(table, i) && n < table->plan->lab_count; n++) {
            const json_t *lab = table_lab(table, i, n);
            if (table_text(lab, "message")[0])
                look_row(page, table, i, table->plan->labs[n], table_text(lab, "status"),
                         table_text(lab, "message"));
        }
    }
    page_end_table(page);
}

static void write_looks(Page *page, const Table *table) {
    fputs("<h2>Who needs a look</h2>\n<p>Not graded for a reason of the grader's, or nothing could be drawn, "
          "or only a part.</p>\n",
          page->out);
    write_look_table(page, table);
    if (table->roster->ignored_count == 0)
        return;
    fputs("<p>Ignored in the class's folder:</p>\n<ul>\n", page->out);
    for (int i = 0; i < table->roster->ignored_count; i++) {
        fputs("<li>", page->out);
        page_text(page, table->roster->ignored[i].name);
        fprintf(page->out, " <span class=\"quiet\">%s</span>", table->roster->ignored[i].why);
        fputs("</li>\n", page->out);
    }
    fputs("</ul>\n", page->out);
}

static void write_row(Page *page, const Table *table, int i) {
    bool graded = table_is_graded(table, i);
    fputs("<tr><td class=\"name\">", page->out);
    write_link(page, table, i);
    fputs("</td>", page->out);
    for (int n = 0; n < table->plan->lab_count; n++) {
        fputs("<td class=\"number\">", page->out);
        if (graded)
            fprintf(page->out, "%.2f", table_number(table_lab(table, i, n), "score"));
        fputs("</td>", page->out);
    }
    fputs("<td class=\"number\">", page->out);
    if (graded)
        fprintf(page->out, "%.2f", table_total(table, i));
    fprintf(page->out, "</td><td>%s</td></tr>\n", table_status(table, i));
}

static void write_all(Page *page, const Table *table) {
    fputs("<h2>All submissions</h2>\n", page->out);
    fputs("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"All "
          "submissions\"><table><thead><tr><th scope=\"col\" "
          "aria-sort=\"ascending\"><button>submission</button></th>",
          page->out);
    for (int n = 0; n < table->plan->lab_count; n++)
        fprintf(page->out, "<th scope=\"col\" class=\"number\"><button>lab %s</button></th>",
                table->plan->labs[n]);
    fputs("<th scope=\"col\" class=\"number\"><button>total</button></th><th "
          "scope=\"col\"><button>status</button></th></tr>"
          "</thead><tbody>\n",
          page->out);
    for (int i = 0; i < table->roster->count; i++)
        write_row(page, table, i);
    page_end_table(page);
}

char *index_page(const Table *table) {
    Page page;
    int graded = 0;
    for (int i = 0; i < table->roster->count; i++)
        graded += table_is_graded(table, i);
    if (!page_begin(&page, "Shadow Lab: the class"))
        return NULL;
    fprintf(page.out,
            "<p>%d submissions, %d graded, %d not graded <span class=\"quiet\">(seed %llu)</span></p>\n",
            table->roster->count, graded, table->roster->count - graded,
            (unsigned long long)table->plan->seed);
    fputs("<h2>Scores</h2>\n", page.out);
    for (int n = 0; n < table->plan->lab_count; n++)
        write_distribution(&page, table, n);
    write_causes(&page, table);
    write_looks(&page, table);
    write_all(&page, table);
    return page_end(&page);
}
