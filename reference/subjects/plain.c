/* A subject for `homeo fuzz orient3d` (docs/SUBJECTS.md): your predicate goes where my_orient3d is.
 * Build and run:  cc -O2 -o plain reference/subjects/plain.c && homeo fuzz orient3d --subject ./plain
 * Shewchuk's orient3d has the opposite sign: declare `double orient3d(double *, double *, double *, double *)`, call it in
 * place of my_orient3d, link predicates.o, call exactinit() first, and add --flip to the command. */
#include <stdio.h>
#include <string.h>

static double my_orient3d(const double *a, const double *b, const double *c, const double *d) {
    double u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = d[k] - a[k];
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

int main(void) {
    char name[32];
    while (scanf("%31s", name) == 1) {
        int known = strcmp(name, "orient3d") == 0;
        double x[12] = {0}, det;
        for (int i = 0; known && i < 12; i++)
            if (scanf("%lf", &x[i]) != 1) return 1;
        if (!known) scanf("%*[^\n]");
        det = my_orient3d(x, x + 3, x + 6, x + 9);
        puts(!known ? "unsupported" : det != det ? "nan" : det > 0 ? "1" : det < 0 ? "-1" : "0");
        fflush(stdout);
    }
    return 0;
}
