/* Rectangles of two triangles that PortableGL draws wrongly (docs/found.md), in a window of 4 x 4 pixels. */
#define PORTABLEGL_IMPLEMENTATION
#include "portablegl.h"

#include <stdio.h>

enum { SIDE = 4 };

static void corner(float* out, vec4* in, Shader_Builtins* builtins, void* uniforms) {
    builtins->gl_Position = in[0];
}

static void white(float* in, Shader_Builtins* builtins, void* uniforms) {
    builtins->gl_FragColor = (vec4){1, 1, 1, 1};
}

/* From (left, bottom) to (right, top), in pixels, y up; `order`: corners of both triangles,
   counter-clockwise. Rows are printed from the top. Pixel (column, row) lies inside. */
static void draw(const u32* pixels, float left, float bottom, float right, float top, const int order[6],
                 int column, int row) {
    const float x[4] = {left, right, right, left}, y[4] = {bottom, bottom, top, top};
    float corners[24];
    for (int i = 0; i < 6; ++i) {
        corners[4 * i] = 2 * x[order[i]] / SIDE - 1;
        corners[4 * i + 1] = 2 * y[order[i]] / SIDE - 1;
        corners[4 * i + 2] = 0;
        corners[4 * i + 3] = 1;
    }
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    for (int i = 0; i < SIDE * SIDE; ++i) {
        putchar(pixels[i] & 0xFFFFFF ? '#' : '.');
        if (i % SIDE == SIDE - 1) putchar(' ');
    }
    printf(" pixel (%d, %d) is %s\n", column, row,
           pixels[row * SIDE + column] & 0xFFFFFF ? "drawn" : "missing");
}

int main(void) {
    u32* pixels = NULL;
    glContext context;
    init_glContext(&context, &pixels, SIDE, SIDE, 32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000);
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, 0);
    GLenum flat[1] = {0};
    glUseProgram(pglCreateProgram(corner, white, 0, flat, GL_FALSE));
    glClearColor(0, 0, 0, 0);
    const int from_first[6] = {0, 1, 2, 0, 2, 3}, from_second[6] = {1, 2, 0, 3, 0, 2};
    draw(pixels, -1, -1, 3.505f, 5, from_first, 3, 0);
    draw(pixels, 1, 1.5f, 2, 3.5f, from_first, 1, 1);
    draw(pixels, 0, 0, 1.5f, 1.5f, from_second, 0, 3);
    return 0;
}
