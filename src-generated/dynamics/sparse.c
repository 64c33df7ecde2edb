/* Weft: dynamics/sparse.c, tangled from chapters/methods/15-direct-contacts.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "dynamics/sparse.h"

enum { NUMBERS_OF_BLOCK = 18, NUMBERS_OF_NODE = WF_NODE_SQUARE + 2 * WF_NODE_ROWS };
#define LOST 1e-11      /* a pivot that is a smaller share of its row says nothing new */

/* take room for a sparse matrix */
static size_t bytes_of_node(void)
{
    return 14 * sizeof(int32_t) + 3 * sizeof(bool)
         + NUMBERS_OF_NODE * sizeof(double);
}

static size_t bytes_of_block(void)
{
    return 2 * sizeof(wfSparseEdge) + sizeof(wfSparseLater) + sizeof(int32_t)
         + NUMBERS_OF_BLOCK * sizeof(double);
}

size_t wfSparseScratch(int32_t nodes, int32_t blocks)
{
    return bytes_of_node() * (size_t)(nodes + 1) + bytes_of_block() * (size_t)blocks
         + 24 * WF_POOL_ALIGN;
}

bool wfSparseTake(wfSparse *m, int32_t nodes, int32_t bodies, wfPool *pool, size_t spare)
{
    *m = (wfSparse){ .nodes = nodes, .bodies = bodies };
    int32_t *numbers = wfPoolPushArray(pool, 14 * (nodes + 1), int32_t);
    m->direct = wfPoolPushArray(pool, 3 * (nodes + 1), bool);
    double *reals = wfPoolPushArray(pool, NUMBERS_OF_NODE * nodes, double);
    if (numbers == NULL || m->direct == NULL || reals == NULL) return false;
    int32_t **const array[14] = { &m->rows, &m->head, &m->mark, &m->list, &m->rank,
        &m->order, &m->degree, &m->bucket, &m->next, &m->before, &m->start, &m->part,
        &m->end, &m->other };
    for (int i = 0; i < 14; i++) *array[i] = numbers + i * (nodes + 1);
    m->ready = m->direct + nodes + 1;
    m->spent = m->ready + nodes + 1;
    m->own = (double(*)[WF_NODE_SQUARE])reals;
    m->x = (double(*)[WF_NODE_ROWS])(reals + (size_t)WF_NODE_SQUARE * (size_t)nodes);
    m->size = m->x + nodes;
    size_t left = wfPoolRoom(pool), least = spare + 8 * WF_POOL_ALIGN;
    if (left < least) return false;
    size_t room = (left - least) / bytes_of_block(), limit = (size_t)1 << 24;
    m->room = (int32_t)(room < limit ? room : limit);
    m->most = NUMBERS_OF_BLOCK * m->room;
    m->edge = wfPoolPushArray(pool, 2 * m->room, wfSparseEdge);
    m->later = wfPoolPushArray(pool, m->room, wfSparseLater);
    m->at = wfPoolPushArray(pool, m->room, int32_t);
    m->number = wfPoolPushArray(pool, m->most, double);
    for (int32_t i = 0; i < nodes; i++) {
        m->head[i] = m->rank[i] = m->end[i] = m->other[i] = -1;
        m->spent[i] = false;
    }
    return m->number != NULL && m->at != NULL && m->later != NULL && m->edge != NULL;
}

/* join nodes */
static int32_t join_nodes(wfSparse *m, int32_t i, int32_t k)
{
    if (m->blocks == m->room) return -1;
    int32_t block = m->blocks++;
    m->edge[2 * block] = (wfSparseEdge){ k, block, m->head[i] };
    m->head[i] = 2 * block;
    m->edge[2 * block + 1] = (wfSparseEdge){ i, block, m->head[k] };
    m->head[k] = 2 * block + 1;
    return block;
}

int32_t wfSparseJoin(wfSparse *m, int32_t body, int32_t node)
{
    m->other[node] = m->end[node];
    m->end[node] = body;
    return join_nodes(m, body, node);
}

/* keep nodes by their degree */
static void put_in_bucket(wfSparse *m, int32_t i)
{
    int32_t first = m->bucket[m->degree[i]];
    m->next[i] = first;
    m->before[i] = -1;
    if (first >= 0) m->before[first] = i;
    m->bucket[m->degree[i]] = i;
}

static void take_from_bucket(wfSparse *m, int32_t i)
{
    int32_t after = m->next[i], before = m->before[i];
    if (after >= 0) m->before[after] = before;
    if (before >= 0) m->next[before] = after;
    else m->bucket[m->degree[i]] = after;
}

/* Lists the nodes that hang together with node i, from place `from' of the list on. */
static int32_t list_part(wfSparse *m, int32_t i, int32_t from)
{
    int32_t to = from;
    m->mark[i] = i;
    m->list[to++] = i;
    for (int32_t n = from; n < to; n++)
        for (int32_t e = m->head[m->list[n]]; e >= 0; e = m->edge[e].next) {
            int32_t k = m->edge[e].to;
            if (m->mark[k] >= 0) continue;
            m->mark[k] = i;
            m->list[to++] = k;
        }
    return to;
}

/* Unlinks from i's list what is gone, and marks what is left with i. */
static void mark_neighbours(wfSparse *m, int32_t i)
{
    int32_t *link = &m->head[i];
    while (*link >= 0) {
        wfSparseEdge *e = &m->edge[*link];
        if (m->rank[e->to] >= 0) {
            *link = e->next;
            continue;
        }
        m->mark[e->to] = i;
        link = &e->next;
    }
}

/* Couples all neighbours of p that are left with each other. False: no room. */
static bool couple_neighbours(wfSparse *m, int32_t p)
{
    for (int32_t e = m->head[p]; e >= 0; e = m->edge[e].next) {
        int32_t i = m->edge[e].to;
        mark_neighbours(m, i);
        for (int32_t f = m->edge[e].next; f >= 0; f = m->edge[f].next) {
            int32_t k = m->edge[f].to;
            if (m->mark[k] == i) continue;
            if (join_nodes(m, i, k) < 0) return false;
            m->degree[i]++, m->degree[k]++;
        }
    }
    return true;
}

/* May a node be eliminated? A body always; see the text. */
static bool may_go(const wfSparse *m, int32_t i)
{
    int32_t a = m->end[i], b = m->other[i];
    if (i < m->bodies) return true;
    bool goneA = a < 0 || m->rank[a] >= 0, goneB = b < 0 || m->rank[b] >= 0;
    if (goneA && goneB) return true;
    return (a >= 0 && goneA && !m->spent[a]) || (b >= 0 && goneB && !m->spent[b]);
}

/* The account of one of its bodies is used up. */
static void spend(wfSparse *m, int32_t p)
{
    int32_t a = m->end[p], b = m->other[p];
    bool ofA = a >= 0 && m->rank[a] >= 0 && !m->spent[a];
    int32_t body = ofA ? a : b;
    if (body >= 0 && m->rank[body] >= 0) m->spent[body] = true;
}

static bool eliminate(wfSparse *m, int32_t p, int32_t *low)
{
    mark_neighbours(m, p);
    spend(m, p);
    for (int32_t e = m->head[p]; e >= 0; e = m->edge[e].next)
        if (m->ready[m->edge[e].to]) take_from_bucket(m, m->edge[e].to);
    if (!couple_neighbours(m, p)) return false;
    for (int32_t e = m->head[p]; e >= 0; e = m->edge[e].next) {
        int32_t i = m->edge[e].to;
        m->degree[i]--;
        m->ready[i] = may_go(m, i);
        if (!m->ready[i]) continue;
        put_in_bucket(m, i);
        if (m->degree[i] < *low) *low = m->degree[i];
    }
    return true;
}

static bool order_part(wfSparse *m, int32_t from, int32_t to)
{
    int32_t low = 0;
    for (int32_t n = to - 1; n >= from; n--) {
        int32_t i = m->list[n];
        m->degree[i] = 0;
        for (int32_t e = m->head[i]; e >= 0; e = m->edge[e].next) m->degree[i]++;
        m->ready[i] = i < m->bodies;
        if (m->ready[i]) put_in_bucket(m, i);
    }
    for (int32_t n = from; n < to; n++) {
        while (m->bucket[low] < 0) low++;
        int32_t p = m->bucket[low];
        take_from_bucket(m, p);
        m->rank[p] = n;
        m->order[n] = p;
        if (!eliminate(m, p, &low)) return false;
    }
    return true;
}

/* lay out the blocks */
static bool lay_out(wfSparse *m, int32_t from, int32_t to, int32_t *laters)
{
    for (int32_t n = from; n < to; n++) {
        int32_t p = m->order[n];
        m->start[n] = *laters;
        for (int32_t e = m->head[p]; e >= 0; e = m->edge[e].next) {
            int32_t k = m->edge[e].to, size = 2 * m->rows[p] * m->rows[k];
            if (m->rank[k] < n) continue;
            if (size > m->most - m->numbers) return false;
            m->later[(*laters)++] = (wfSparseLater){ k, m->edge[e].block };
            m->at[m->edge[e].block] = m->numbers;
            m->numbers += size;
        }
    }
    m->start[to] = *laters;
    return true;
}

void wfSparseOrder(wfSparse *m)
{
    int32_t laters = 0;
    for (int32_t i = 0; i < m->nodes; i++) m->bucket[i] = m->mark[i] = -1;
    for (int32_t i = 0; i < m->nodes; i++) {
        if (m->head[i] < 0 || m->mark[i] >= 0) continue;
        m->part[m->parts] = m->listed;
        m->listed = list_part(m, i, m->listed);
        m->part[++m->parts] = m->listed;
    }
    for (int32_t i = 0; i < m->nodes; i++) m->mark[i] = -1;
    for (int32_t k = 0; k < m->parts; k++) {
        int32_t from = m->part[k], to = m->part[k + 1], had = laters;
        int32_t numbers = m->numbers, blocks = m->blocks;
        m->direct[k] = order_part(m, from, to) && lay_out(m, from, to, &laters);
        if (m->direct[k]) continue;
        m->numbers = numbers, m->blocks = blocks, laters = had;
        for (int32_t i = 0; i < m->nodes; i++) m->bucket[i] = -1;
    }
}

/* read and clear the blocks */
double *wfSparseBlock(const wfSparse *m, int32_t block, int32_t row, int32_t column)
{
    double *upper = &m->number[m->at[block]];
    return m->rank[row] < m->rank[column] ? upper : upper + m->rows[row] * m->rows[column];
}

void wfSparseClear(wfSparse *m, int32_t part)
{
    int32_t from = m->part[part], to = m->part[part + 1];
    for (int32_t n = from; n < to; n++) {
        int32_t p = m->order[n];
        memset(m->own[p], 0, sizeof m->own[p]);
        for (int32_t e = m->start[n]; e < m->start[n + 1]; e++) {
            size_t size = 2 * (size_t)(m->rows[p] * m->rows[m->later[e].to]);
            memset(&m->number[m->at[m->later[e].block]], 0, size * sizeof(double));
        }
    }
}

/* The inverse of an n x n block in place. Rows that say nothing new become zero. */
static void invert(double *a, int n, const double *size)
{
    double full[WF_NODE_ROWS][2 * WF_NODE_ROWS] = { { 0 } };
    bool used[WF_NODE_ROWS] = { false }, lost[WF_NODE_ROWS] = { false };
    int from[WF_NODE_ROWS];
    for (int r = 0; r < n; r++) {
        for (int c = 0; c < n; c++) full[r][c] = a[r * n + c];
        full[r][WF_NODE_ROWS + r] = 1;
    }
    for (int c = 0; c < n; c++) {
        int best = -1;
        double most = 0;
        for (int r = 0; r < n; r++) {
            double v = full[r][c] < 0 ? -full[r][c] : full[r][c];
            if (!used[r] && v > LOST * size[r] && v > most) best = r, most = v;
        }
        lost[c] = best < 0;
        if (lost[c]) continue;
        used[best] = true;
        from[c] = best;
        for (int r = 0; r < n; r++) {
            double f = full[r][c] / full[best][c];
            for (int k = 0; r != best && k < 2 * WF_NODE_ROWS; k++)
                full[r][k] -= f * full[best][k];
        }
    }
    for (int c = 0; c < n; c++)
        for (int k = 0; k < n; k++)
            a[c * n + k] = lost[c] ? 0 : full[from[c]][WF_NODE_ROWS + k] / full[from[c]][c];
}

/* c -= a b, where a has r rows and n columns, b has s columns */
static void take_product(double *c, const double *a, const double *b, int r, int n, int s)
{
    for (int i = 0; i < r; i++)
        for (int k = 0; k < s; k++) {
            double sum = 0;
            for (int j = 0; j < n; j++) sum += a[i * n + j] * b[j * s + k];
            c[i * s + k] -= sum;
        }
}

/* Own^-1 times the block to a later node, in place. */
static void divide_block(const wfSparse *m, int32_t p, const wfSparseLater *to)
{
    double *block = wfSparseBlock(m, to->block, p, to->to), copy[WF_NODE_SQUARE];
    int n = m->rows[p], columns = m->rows[to->to];
    memcpy(copy, block, (size_t)(n * columns) * sizeof *copy);
    for (int i = 0; i < n * columns; i++) block[i] = 0;
    take_product(block, m->own[p], copy, n, n, columns);
    for (int i = 0; i < n * columns; i++) block[i] = -block[i];
}

/* What p's elimination does to its later neighbour i, and to i and each later one. */
static void spread(wfSparse *m, int32_t n, const wfSparseLater *to)
{
    int32_t p = m->order[n], i = to->to, at = m->rank[i];
    const double *down = wfSparseBlock(m, to->block, i, p);
    const double *right = wfSparseBlock(m, to->block, p, i);
    int mine = m->rows[i], inner = m->rows[p];
    take_product(m->own[i], down, right, mine, inner, mine);
    for (int32_t e = m->start[at]; e < m->start[at + 1]; e++)
        m->mark[m->later[e].to] = m->later[e].block;
    for (int32_t e = m->start[n]; e < m->start[n + 1]; e++) {
        int32_t k = m->later[e].to, theirs = m->rows[k];
        if (m->rank[k] <= at) continue;
        const double *kDown = wfSparseBlock(m, m->later[e].block, k, p);
        const double *kRight = wfSparseBlock(m, m->later[e].block, p, k);
        double *ik = wfSparseBlock(m, m->mark[k], i, k);        /* eq:exact-eliminate */
        take_product(ik, down, kRight, mine, inner, theirs);
        take_product(wfSparseBlock(m, m->mark[k], k, i), kDown, right, theirs, inner, mine);
    }
}

void wfSparseFactor(wfSparse *m, int32_t part)
{
    for (int32_t n = m->part[part]; n < m->part[part + 1]; n++) {
        int32_t p = m->order[n];
        invert(m->own[p], m->rows[p], m->size[p]);
        for (int32_t e = m->start[n]; e < m->start[n + 1]; e++)
            divide_block(m, p, &m->later[e]);
        for (int32_t e = m->start[n]; e < m->start[n + 1]; e++) spread(m, n, &m->later[e]);
    }
}

/* solve with a sparse matrix */
void wfSparseSolve(wfSparse *m, int32_t part)
{
    for (int32_t n = m->part[part]; n < m->part[part + 1]; n++) {
        int32_t p = m->order[n], size = m->rows[p];
        double b[WF_NODE_ROWS] = { 0 };
        take_product(b, m->own[p], m->x[p], size, size, 1);
        for (int i = 0; i < size; i++) m->x[p][i] = -b[i];
        for (int32_t e = m->start[n]; e < m->start[n + 1]; e++) {
            int32_t i = m->later[e].to;
            const double *down = wfSparseBlock(m, m->later[e].block, i, p);
            take_product(m->x[i], down, m->x[p], m->rows[i], size, 1);
        }
    }
    for (int32_t n = m->part[part + 1] - 1; n >= m->part[part]; n--) {
        int32_t p = m->order[n];
        for (int32_t e = m->start[n]; e < m->start[n + 1]; e++) {
            int32_t i = m->later[e].to;
            const double *right = wfSparseBlock(m, m->later[e].block, p, i);
            take_product(m->x[p], right, m->x[i], m->rows[p], m->rows[i], 1);
        }
    }
}
