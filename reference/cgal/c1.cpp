// Claim C1 `positivity` with CGAL: the signs of the 24 tets of every prism.
//
//   c1 [--epeck] [--repeat N] BOTTOM.off MIDDLE.off TOP.off
//
// Prints one line of key=value: prisms, tets (those on a pinched pillar left out), not_positive, and the smallest and
// the median time of N evaluations. Reading and building CGAL points are not timed.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>
#include <iomanip>

#include "tets.hpp"

struct Counts {
  std::size_t tets = 0, bad = 0;
};

template <class Point>
Counts evaluate(const Shell& shell, const std::array<std::vector<Point>, 3>& points, const std::vector<char>& pinched,
                const std::vector<LocalTet>& tets) {
  Counts out;
  for (const Face& face : shell.faces) {
    const std::array<bool, 3> flat{bool(pinched[face[0]]), bool(pinched[face[1]]), bool(pinched[face[2]])};
    const bool any = flat[0] || flat[1] || flat[2];
    for (const LocalTet& tet : tets) {
      if (any && vanishes(tet, flat)) continue;
      const auto at = [&](int i) -> const Point& { return points[tet[i].layer][face[tet[i].corner]]; };
      ++out.tets;
      if (CGAL::orientation(at(0), at(1), at(2), at(3)) != CGAL::POSITIVE) ++out.bad;
    }
  }
  return out;
}

template <class Kernel>
void run(const Shell& shell, int repeat) {
  using Point = typename Kernel::Point_3;
  std::array<std::vector<Point>, 3> points;
  for (int layer = 0; layer < 3; ++layer)
    for (const Row& row : shell.layers[layer]) points[layer].emplace_back(row[0], row[1], row[2]);
  std::vector<char> pinched;
  for (std::size_t v = 0; v < shell.layers[0].size(); ++v) pinched.push_back(shell.pinched(v));
  const auto tets = prism_tets();
  Counts counts;
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    counts = evaluate(shell, points, pinched, tets);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << std::setprecision(9) << "prisms=" << shell.faces.size() << " tets=" << counts.tets
            << " not_positive=" << counts.bad << " min_seconds=" << seconds.front()
            << " median_seconds=" << seconds[seconds.size() / 2] << '\n';
}

int main(int argc, char** argv) {
  bool epeck = false;
  int repeat = 1, at = 1;
  for (; at < argc && argv[at][0] == '-'; ++at) {
    const std::string option = argv[at];
    if (option == "--epeck") {
      epeck = true;
    } else if (option == "--repeat" && at + 1 < argc) {
      repeat = std::max(1, std::atoi(argv[++at]));
    } else {
      refuse("unknown option " + option);
    }
  }
  if (argc - at != 3) refuse("usage: c1 [--epeck] [--repeat N] BOTTOM.off MIDDLE.off TOP.off");
  const Shell shell = read_shell(argv + at);
  if (epeck) {
    run<CGAL::Exact_predicates_exact_constructions_kernel>(shell, repeat);
  } else {
    run<CGAL::Exact_predicates_inexact_constructions_kernel>(shell, repeat);
  }
}
