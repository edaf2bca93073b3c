// orient3d with CGAL, timed here. Built as orient_epick, orient_epick_native (-march=native) and orient_epeck.
//
// Reads one line, then little-endian data:
//   quads N          12 N doubles: four points an input, one input after another
//   streams N        12 N doubles: N times x of the first point, N times its y, ...
//   indexed V N      3 V doubles, then 4 N 32-bit indices
// says `ready`, and decides all inputs once for every line `run`; the answer is one line of key=value: seconds, positive,
// zero. Points of `quads` and `indexed` are built before the clock starts; `streams` is read as it is.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>

#include "serve.hpp"

#ifdef ORIENT_EPECK
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#endif
using Point = Kernel::Point_3;

template <class Number>
std::vector<Number> read(std::size_t count) {
  std::vector<Number> out(count);
  if (!std::cin.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(count * sizeof(Number))))
    refuse("the data end too early");
  return out;
}

std::vector<Point> read_points(std::size_t count) {
  const auto numbers = read<double>(3 * count);
  std::vector<Point> out;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  return out;
}

// Every sign is written down, as the other side does.
template <class Orient>
void answer(std::size_t count, const Orient& orient) {
  std::vector<std::int8_t> signs(count);
  serve([&] {
    Watch watch;
    for (std::size_t i = 0; i < count; ++i) signs[i] = static_cast<std::int8_t>(orient(i));
    const double seconds = watch.lap();
    std::cout << "seconds=" << seconds << " positive=" << std::count(signs.begin(), signs.end(), 1)
              << " zero=" << std::count(signs.begin(), signs.end(), 0) << '\n';
  });
}

int main() {
  std::ios::sync_with_stdio(false);
  std::string line, layout;
  std::getline(std::cin, line);
  std::istringstream words(line);
  std::size_t vertices = 0, count = 0;
  words >> layout;
  if (layout == "indexed") words >> vertices;
  if (!(words >> count)) refuse("not a layout and its counts: " + line);
  if (layout == "quads") {
    const auto points = read_points(4 * count);
    answer(count, [&](std::size_t i) {
      const Point* p = &points[4 * i];
      return CGAL::orientation(p[0], p[1], p[2], p[3]);
    });
  } else if (layout == "streams") {
    const auto x = read<double>(12 * count);
    const auto at = [&](std::size_t point, std::size_t i) {
      const double* from = &x[3 * point * count + i];
      return Point(from[0], from[count], from[2 * count]);
    };
    answer(count, [&](std::size_t i) { return CGAL::orientation(at(0, i), at(1, i), at(2, i), at(3, i)); });
  } else if (layout == "indexed") {
    const auto points = read_points(vertices);
    const auto ids = read<std::uint32_t>(4 * count);
    for (const std::uint32_t id : ids)
      if (id >= vertices) refuse("an index is out of range");
    answer(count, [&](std::size_t i) {
      const std::uint32_t* q = &ids[4 * i];
      return CGAL::orientation(points[q[0]], points[q[1]], points[q[2]], points[q[3]]);
    });
  } else {
    refuse("no layout " + layout);
  }
}
