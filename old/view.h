#ifndef VIEW_H
#define VIEW_H
#include "entry.h"
typedef struct {
Window window;
Pack *cut;
} View;
extern const Key view_keys[];
extern const Key view_edges[];
EdgesHow view_how(const Scene *scene, const Asked *measure, unsigned facts);
int view_check(const Query *query);
int view_ask(const Query *query, unsigned facts, const Box *box);
int view_through(View *view, Work *work);
void view_close(View *view);
#endif
