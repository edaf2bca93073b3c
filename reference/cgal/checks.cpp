// Claim C6 `disjoint` with CGAL: the mesh against itself, and against the shell's bottom and top.
//
//   checks BOTTOM.off MIDDLE.off TOP.off MESH.off
//
// Prints one line of key=value: pairs of mesh triangles that share more than their common vertices force (`self`), and
// pairs of a mesh triangle and a bottom or top triangle that share a point other than a pinched vertex.
#include "checks.hpp"

int main(int argc, char** argv) {
  if (argc != 5) refuse("usage: checks BOTTOM.off MIDDLE.off TOP.off MESH.off");
  const Shell shell = read_shell(argv + 1);
  const Mesh mesh = read_off(argv[4]);
  std::cout << "self=" << self_hits(mesh) << " bottom=" << layer_hits(mesh, shell, 0)
            << " top=" << layer_hits(mesh, shell, 2) << '\n';
}
