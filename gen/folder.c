/* folder.c -- the folder of a set: beginning it, stamps and locks of shards. */
#include "gen.h"
#include "set.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { LINE = GEN_PATH + GEN_TEXT };

/* --- stamps --- */

/* A line of a file without its end; 0 at the end of the file. */
static int next_line(FILE *f, char *line)
{
    size_t length;

    if (!fgets(line, LINE, f))
        return 0;
    length = strlen(line);
    if (length > 0 && line[length - 1] == '\n')
        line[length - 1] = 0;
    return 1;
}

/* The call that a stamp names; 0 if the file is not there, or empty as yet. */
static int read_stamp(const char *path, char *text)
{
    char line[LINE] = "";
    FILE *f = fopen(path, "rb");
    int there;

    if (!f)
        return 0;
    there = next_line(f, line) && strncmp(line, "# ", 2) == 0;
    fclose(f);
    if (there)
        snprintf(text, GEN_TEXT, "%.*s", GEN_TEXT - 1, line + 2);
    return there;
}

static int is_stamp(const char *name)
{
    const char *end = strrchr(name, '.');

    return name[0] != '.' && end &&
           (strcmp(end, ".done") == 0 || strcmp(end, ".begun") == 0);
}

/* The first stamp of the folder that names a call other than `but` (NULL: any). */
static int find_stamp(const char *folder, const char *but, char *text)
{
    char path[2 * GEN_PATH];
    DIR *all;
    int found = 0;

    snprintf(path, sizeof path, "%s/shards", folder);
    all = opendir(path);
    if (!all)
        return 0;
    for (const struct dirent *entry; !found && (entry = readdir(all));) {
        if (!is_stamp(entry->d_name))
            continue;
        snprintf(path, sizeof path, "%s/shards/%s", folder, entry->d_name);
        found = read_stamp(path, text) && !(but && strcmp(text, but) == 0);
    }
    closedir(all);
    return found;
}

int gen_folder_call(const char *folder, char *text)
{
    return find_stamp(folder, NULL, text);
}

int gen_folder_each(const gen_call *c, int shard,
                    int (*visit)(void *with, const char *sum, const char *relative),
                    void *with, uint64_t *bytes)
{
    char path[GEN_PATH], full[GEN_PATH], line[LINE];
    int result = 0;
    FILE *f;

    gen_path_stamp(c, shard, "done", path);
    gen_path_join(c, path, full);
    f = fopen(full, "rb");
    if (!f)
        return -1;
    if (!next_line(f, line) || strncmp(line, "# ", 2) != 0 ||
        strcmp(line + 2, c->text) != 0)
        result = -1;
    while (result == 0 && next_line(f, line)) {
        char *space = strstr(line, "  ");

        if (line[0] == '#') {
            if (bytes)
                *bytes = strtoull(line + 1, NULL, 10);
        } else if (space) {
            *space = 0;
            result = visit(with, line, space + 2);
        }
    }
    fclose(f);
    return result;
}

typedef struct sizes {
    const gen_call *call;
    uint64_t bytes;
} sizes;

static int add_size(void *with, const char *sum, const char *relative)
{
    sizes *s = with;
    char path[GEN_PATH];
    struct stat status;

    (void)sum;
    gen_path_join(s->call, relative, path);
    if (stat(path, &status) != 0)
        return 1;
    s->bytes += (uint64_t)status.st_size;
    return 0;
}

int gen_folder_complete(const gen_call *c, int shard)
{
    sizes s = {.call = c};
    uint64_t bytes = UINT64_MAX;

    return gen_folder_each(c, shard, add_size, &s, &bytes) == 0 && s.bytes == bytes;
}

/* --- beginning --- */

static int make_folder(const char *path)
{
    struct stat status;

    if (mkdir(path, 0777) == 0 ||
        (errno == EEXIST && stat(path, &status) == 0 && S_ISDIR(status.st_mode)))
        return GEN_GOOD;
    return gen_say(GEN_BAD_INPUT, "cannot make the folder %s: %s", path, strerror(errno));
}

static int has_entries(const char *path)
{
    DIR *all = opendir(path);
    int found = 0;

    if (!all)
        return 0;
    for (const struct dirent *entry; !found && (entry = readdir(all));)
        found = strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    closedir(all);
    return found;
}

static int make_below(const gen_call *c, const char *name)
{
    char path[GEN_PATH];

    gen_path_join(c, name, path);
    return make_folder(path);
}

static int make_all_below(const gen_call *c, const gen_plan *p)
{
    int status = GEN_GOOD;

    if (c->format[GEN_CSV] || c->format[GEN_NPY])
        for (int a = 0; a < p->arrays && status == GEN_GOOD; a++)
            status = make_below(c, p->array[a].name);
    for (int f = GEN_OWN_FORMAT; f < GEN_FORMATS && status == GEN_GOOD; f++)
        if (c->format[f])
            status = make_below(c, gen_format_name(c, f));
    return status;
}

int gen_folder_begin(const gen_call *c, const gen_plan *p)
{
    char text[GEN_TEXT], shards[GEN_PATH];
    struct stat status;

    gen_path_join(c, "shards", shards);
    /* looked at last: somebody who begins the same set makes it before all else */
    if (has_entries(c->out) && stat(shards, &status) != 0)
        return gen_say(GEN_BAD_INPUT, "%s is not empty and holds no set", c->out);
    if (make_folder(c->out) != GEN_GOOD || make_folder(shards) != GEN_GOOD)
        return GEN_BAD_INPUT;
    if (find_stamp(c->out, c->text, text))
        return gen_say(GEN_BAD_INPUT, "%s holds another set: %s", c->out, text);
    return make_all_below(c, p);
}

/* --- locks --- */

int gen_folder_begun(const gen_call *c, int shard)
{
    char relative[GEN_PATH], path[GEN_PATH];

    gen_path_stamp(c, shard, "begun", relative);
    gen_path_join(c, relative, path);
    return access(path, F_OK) == 0;
}

/* 0 if somebody else has it and keeps it for two seconds: a worker whose parent was killed needs a
   moment to notice. A file system without locks gives it to everybody. */
static int take_lock(int file)
{
    const struct timespec moment = {.tv_nsec = 100000000};
    struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    for (int i = 0; i < 20; i++) {
        if (fcntl(file, F_SETLK, &lock) == 0 || (errno != EACCES && errno != EAGAIN))
            return 1;
        nanosleep(&moment, NULL);
    }
    return 0;
}

static int write_stamp(int file, const char *text)
{
    char line[GEN_TEXT + 4];
    int length = snprintf(line, sizeof line, "# %s\n", text);

    return pwrite(file, line, (size_t)length, 0) == length &&
           ftruncate(file, length) == 0;
}

/* Who had the lock before may have removed the file: then it is nobody's, and another has its name. */
static int is_removed(int file)
{
    struct stat status;

    return fstat(file, &status) == 0 && status.st_nlink == 0;
}

static int open_locked(const char *path)
{
    for (;;) {
        int file = open(path, O_RDWR | O_CREAT, 0666);

        if (file < 0)
            return gen_say(-1, "cannot write %s: %s", path, strerror(errno));
        if (!take_lock(file)) {
            close(file);
            return gen_say(-1, "%s: another process is at work on it", path);
        }
        if (!is_removed(file))
            return file;
        close(file);
    }
}

int gen_folder_lock(const gen_call *c, int shard)
{
    char relative[GEN_PATH], path[GEN_PATH];
    int file;

    gen_path_stamp(c, shard, "begun", relative);
    gen_path_join(c, relative, path);
    file = open_locked(path);
    if (file < 0)
        return -1;
    errno = EIO;
    if (!write_stamp(file, c->text)) {
        gen_say(-1, "cannot write %s: %s", path, strerror(errno));
        close(file);
        return -1;
    }
    return file;
}

void gen_folder_unlock(const gen_call *c, int shard, int lock, int done)
{
    char relative[GEN_PATH], path[GEN_PATH];

    gen_path_stamp(c, shard, "begun", relative);
    gen_path_join(c, relative, path);
    if (done)
        unlink(path);
    close(lock);
}
