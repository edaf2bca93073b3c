// The contact part of claim C3+ `i2` with CGAL: triangles of the mesh against all tets of the shell.
//
//   contacts BOTTOM.off MIDDLE.off TOP.off MESH.off
//
// Prints one line of key=value. `contacts`: pairs of a mesh triangle and a different tet of a prism that share a point
// other than a pinched vertex, although the triangle's dot with the tet's pillar half is not positive. `touching`: pairs that
// share a point, whatever the dot.
#include "contacts.hpp"

int main(int argc, char** argv) {
  if (argc != 5) refuse("usage: contacts BOTTOM.off MIDDLE.off TOP.off MESH.off");
  const Shell shell = read_shell(argv + 1);
  const Mesh mesh = read_off(argv[4]);
  const auto pinched = pinched_points(shell);
  std::vector<Solid> tets;
  for (const Face& face : shell.faces)
    for (const Solid& tet : prism_solids(shell, face)) tets.push_back(tet);
  const auto triangle_ids = ids_of(mesh.faces.size()), tet_ids = ids_of(tets.size());
  auto triangles = triangle_boxes(mesh.points, mesh.faces, triangle_ids);
  std::vector<Box> boxes;
  for (const std::size_t& t : tet_ids) boxes.emplace_back(tetrahedron<Fast>(tets[t]).bbox(), &t);
  std::size_t contacts = 0, touching = 0;
  const DotOf<Fast>::type dot;
  CGAL::box_intersection_d(triangles.begin(), triangles.end(), boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const std::size_t f = *a.handle();
    const Solid& tet = tets[*b.handle()];
    const auto face = triangle<Fast>(mesh.points, mesh.faces[f]);
    if (!CGAL::do_intersect(face, tetrahedron<Fast>(tet))) return;
    ++touching;
    if (dot(face[0], face[1], face[2], point<Fast>(tet.lo), point<Fast>(tet.hi)) == CGAL::POSITIVE) return;
    if (!only_pinched(mesh, f, tet, pinched)) ++contacts;
  });
  std::cout << "touching=" << touching << " contacts=" << contacts << '\n';
}
