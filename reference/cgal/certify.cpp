// A straightforward certifier with CGAL: the checks behind claims C1 to C4, C6 and C3+ for closed meshes and shells that do
// not overlap themselves. It gives verdicts and no proofs.
//
//   certify [--pieces] [--serve] BOTTOM.off MIDDLE.off TOP.off MESH.off
//
// C1: the signs of all tets. C2 to C4, for all vertex orders: no triangle touches a tet with whose pillar half its dot is
// not positive; the mesh meets neither bottom nor top; both surfaces have as many components, the same Euler
// characteristic, and a fibre over each component of the middle surface meets the mesh exactly once. The projection is then
// a covering with one sheet. C6 adds the mesh against itself. --pieces also cuts every triangle by the tets of one vertex
// order that it meets, with exact constructions: what a proof of C2 has to name, so that the work is that of a certifier
// which shows its section.
//
// Prints one line of key=value; with --serve one for every line `run` of standard input. Verdicts: `positivity`, `section`
// (with bijection, for all orders), `disjoint`, `i2`; 1 if shown, else 0. Counts: tets, not_positive, contacts, self,
// bottom, top, fibres (those that meet the mesh once), pieces (with area). Seconds: of C1, contacts, layers, fibres, pieces,
// self. Reading is not timed.
#include "checks.hpp"
#include "contacts.hpp"
#include "positivity.hpp"
#include "serve.hpp"

// Components, and an index of one vertex of each.
std::vector<std::size_t> roots(std::size_t vertices, const std::vector<Face>& faces) {
  auto parent = ids_of(vertices);
  const auto find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Face& f : faces)
    for (int i = 1; i < 3; ++i) parent[find(f[i])] = find(f[0]);
  std::vector<char> used(vertices);
  for (const Face& f : faces) used[f[0]] = 1;
  std::set<std::size_t> out;
  for (std::size_t v = 0; v < vertices; ++v)
    if (used[v]) out.insert(find(v));
  return {out.begin(), out.end()};
}

// Vertices that are used, minus edges, plus faces. Refuses boundaries.
long euler(const std::vector<Face>& faces) {
  std::vector<std::size_t> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const Face& f : faces)
    for (int i = 0; i < 3; ++i) {
      vertices.push_back(f[i]);
      edges.push_back(std::minmax(f[i], f[(i + 1) % 3]));
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (2 * edges.size() != 3 * faces.size()) refuse("not a closed surface");
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) + static_cast<long>(faces.size());
}

// The different points in which the pillar of a vertex meets the mesh; 2 for more than one.
std::size_t meetings(const Mesh& mesh, const Shell& shell, std::size_t v) {
  std::set<Exact::Point_3> points;
  for (const Face& face : mesh.faces)
    for (int slab = 0; slab < 2; ++slab) {
      const Row &lo = shell.layers[slab][v], &hi = shell.layers[slab + 1][v];
      if (lo == hi) {
        if (triangle<Fast>(mesh.points, face).has_on(point<Fast>(lo))) points.insert(point<Exact>(lo));
        continue;
      }
      if (!CGAL::do_intersect(triangle<Fast>(mesh.points, face), Fast::Segment_3(point<Fast>(lo), point<Fast>(hi)))) continue;
      const auto common = CGAL::intersection(triangle<Exact>(mesh.points, face),
                                             Exact::Segment_3(point<Exact>(lo), point<Exact>(hi)));
      const auto* at = common ? boost::get<Exact::Point_3>(&*common) : nullptr;
      if (!at) return 2;
      points.insert(*at);
    }
  return std::min<std::size_t>(points.size(), 2);
}

// The tets of a prism in the order of vertex numbers.
std::vector<Solid> solids_by_number(const Shell& shell, Face face) {
  std::sort(face.begin(), face.end());
  std::vector<Solid> out;
  for (int slab = 0; slab < 2; ++slab) {
    const auto lo = [&](int k) { return shell.layers[slab][face[k]]; };
    const auto hi = [&](int k) { return shell.layers[slab + 1][face[k]]; };
    const std::array<Solid, 3> tets{Solid{{lo(0), lo(1), lo(2), hi(2)}, lo(2), hi(2)},
                                    Solid{{lo(0), lo(1), hi(1), hi(2)}, lo(1), hi(1)},
                                    Solid{{lo(0), hi(0), hi(1), hi(2)}, lo(0), hi(0)}};
    for (const Solid& tet : tets)
      if (tet.lo != tet.hi) out.push_back(tet);
  }
  return out;
}

// All pieces with area of the mesh in the tets of one vertex order, their corners known exactly.
std::size_t exact_pieces(const Mesh& mesh, const Shell& shell) {
  const auto mesh_ids = ids_of(mesh.faces.size()), shell_ids = ids_of(shell.faces.size());
  auto triangles = triangle_boxes(mesh.points, mesh.faces, mesh_ids);
  auto prisms = prism_boxes(shell, shell_ids);
  std::size_t pieces = 0;
  CGAL::box_intersection_d(triangles.begin(), triangles.end(), prisms.begin(), prisms.end(), [&](const Box& a, const Box& b) {
    const Face& face = mesh.faces[*a.handle()];
    for (const Solid& tet : solids_by_number(shell, shell.faces[*b.handle()])) {
      if (!CGAL::do_intersect(triangle<Fast>(mesh.points, face), tetrahedron<Fast>(tet))) continue;
      const auto common = CGAL::intersection(triangle<Exact>(mesh.points, face), tetrahedron<Exact>(tet));
      if (!common) continue;
      std::vector<Exact::Point_3> corners;
      if (const auto* t = boost::get<Exact::Triangle_3>(&*common)) corners = {t->vertex(0), t->vertex(1), t->vertex(2)};
      if (const auto* many = boost::get<std::vector<Exact::Point_3>>(&*common)) corners = *many;
      for (const auto& corner : corners) CGAL::exact(corner);
      pieces += !corners.empty();
    }
  });
  return pieces;
}

void certify(const Shell& shell, const Mesh& mesh, bool with_pieces) {
  Watch watch;
  const Counts counts = PointShell<Fast>(shell).positivity();
  const double c1_seconds = watch.lap();
  const std::size_t contacts = contacts_by_prisms(mesh, shell);
  const double contact_seconds = watch.lap();
  const std::size_t bottom = layer_hits(mesh, shell, 0), top = layer_hits(mesh, shell, 2);
  const double layer_seconds = watch.lap();
  const auto middle = roots(shell.layers[1].size(), shell.faces);
  const bool same = middle.size() == roots(mesh.points.size(), mesh.faces).size() && euler(shell.faces) == euler(mesh.faces);
  std::size_t once = 0;
  for (const std::size_t v : middle) once += meetings(mesh, shell, v) == 1;
  const double fibre_seconds = watch.lap();
  const std::size_t pieces = with_pieces ? exact_pieces(mesh, shell) : 0;
  const double piece_seconds = watch.lap();
  const std::size_t self = self_hits(mesh);
  const double self_seconds = watch.lap();
  const bool positivity = counts.bad == 0, inside = bottom + top == 0;
  const bool section = positivity && contacts == 0 && inside && same && once == middle.size();
  std::cout << std::setprecision(9) << "positivity=" << positivity << " section=" << section
            << " disjoint=" << (inside && self == 0) << " i2=" << section << " tets=" << counts.tets
            << " not_positive=" << counts.bad << " contacts=" << contacts << " self=" << self << " bottom=" << bottom
            << " top=" << top << " fibres=" << once << " pieces=" << pieces << " c1_seconds=" << c1_seconds << " contact_seconds=" << contact_seconds
            << " layer_seconds=" << layer_seconds << " fibre_seconds=" << fibre_seconds << " piece_seconds=" << piece_seconds << " self_seconds=" << self_seconds
            << '\n';
}

int main(int argc, char** argv) {
  bool pieces = false, stay = false;
  int at = 1;
  for (; at < argc && argv[at][0] == '-'; ++at) {
    const std::string option = argv[at];
    if (option == "--pieces") {
      pieces = true;
    } else if (option == "--serve") {
      stay = true;
    } else {
      refuse("unknown option " + option);
    }
  }
  if (argc - at != 4) refuse("usage: certify [--pieces] [--serve] BOTTOM.off MIDDLE.off TOP.off MESH.off");
  const Shell shell = read_shell(argv + at);
  const Mesh mesh = read_off(argv[at + 3]);
  const auto once = [&] { certify(shell, mesh, pieces); };
  stay ? serve(once) : once();
}
