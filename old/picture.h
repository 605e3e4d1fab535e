#ifndef PICTURE_H
#define PICTURE_H
#include "scene.h"
typedef struct {
const char *color;
const char *cut;
const char *frame;
const Scene *scene;
} PictureView;
int picture_view(const char *path, const PictureView *view, const char *picture,
Outcome *out);
#endif
