#include "ui/charts/plotting/thinning.h"

#include <algorithm>
#include <cmath>

#include "ui/charts/plotting/clipping.h"

namespace alidade::ui {
namespace {

constexpr std::size_t fewMarks = 5000, fewSticks = 1000;
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// What was chosen in each cell, kind by kind.
class Cells {
 public:
  Cells(const Raster& raster, std::size_t kinds)
      : m_raster(raster),
        m_columns(countOf(raster.area.width(), raster.cell)),
        m_rows(countOf(raster.area.height(), raster.cell)),
        m_chosen(m_columns * m_rows * kinds, none) {}

  /// Index of what was chosen where this one lies, or in the cell nearest to it.
  std::size_t& at(const QPointF& point, std::size_t kind) {
    const std::size_t column = indexOf(point.x() - m_raster.area.left(), m_columns);
    const std::size_t row = indexOf(point.y() - m_raster.area.top(), m_rows);
    return m_chosen[(kind * m_rows + row) * m_columns + column];
  }
  void addTo(std::vector<bool>& wanted) const {
    for (const std::size_t index : m_chosen)
      if (index != none) wanted[index] = true;
  }

 private:
  static std::size_t countOf(double length, double cell) {
    constexpr double most = 4000;
    return static_cast<std::size_t>(std::clamp(std::ceil(length / cell), 1.0, most));
  }
  std::size_t indexOf(double offset, std::size_t count) const {
    const double index = offset / m_raster.cell;
    if (!(index > 0)) return 0;
    return index < static_cast<double>(count) ? static_cast<std::size_t>(index) : count - 1;
  }

  Raster m_raster;
  std::size_t m_columns, m_rows;
  std::vector<std::size_t> m_chosen;
};

/// Which eighth of a turn it points into, 0 to 7.
std::size_t eighthOf(const QLineF& line) {
  return (line.dx() > 0 ? 1U : 0U) + (line.dy() > 0 ? 2U : 0U) +
         (std::abs(line.dx()) > std::abs(line.dy()) ? 4U : 0U);
}

double lengthOf(const Stick& stick) {
  return std::hypot(stick.line.dx(), stick.line.dy());
}

template <typename Value>
std::size_t kindsOf(const std::vector<Value>& values) {
  std::size_t kinds = 1;
  for (const Value& value : values) kinds = std::max(kinds, value.kind + 1);
  return kinds;
}

template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& all, const std::vector<bool>& wanted) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (wanted[i]) values.push_back(all[i]);
  return values;
}

}  // namespace

std::vector<PlacedMark> thinned(const std::vector<Mark>& marks, const QTransform& sceneFromAxes,
                                const Raster& raster) {
  std::vector<PlacedMark> placed;
  placed.reserve(marks.size());
  for (const Mark& mark : marks) {
    const QPointF at = sceneFromAxes.map(mark.at) + mark.shift;
    if (raster.area.contains(at)) placed.push_back({at, mark.kind});
  }
  if (placed.size() <= fewMarks) return placed;
  Cells uppermost(raster, kindsOf(placed)), lowest = uppermost;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto& [at, kind] = placed[i];
    std::size_t &up = uppermost.at(at, kind), &down = lowest.at(at, kind);
    if (up == none || at.y() < placed[up].at.y()) up = i;
    if (down == none || at.y() > placed[down].at.y()) down = i;
  }
  std::vector<bool> wanted(placed.size());
  uppermost.addTo(wanted);
  lowest.addTo(wanted);
  return chosen(placed, wanted);
}

std::vector<Stick> thinned(const std::vector<Stick>& sticks, const QTransform& sceneFromAxes,
                           const Raster& raster) {
  std::vector<Stick> placed;
  placed.reserve(sticks.size());
  for (const Stick& stick : sticks) {
    const auto line = clipped(sceneFromAxes.map(stick.line).translated(stick.shift), raster.area);
    if (line) placed.push_back({*line, stick.kind});
  }
  if (placed.size() <= fewSticks) return placed;
  Cells longest(raster, 8 * kindsOf(placed));
  for (std::size_t i = 0; i < placed.size(); ++i) {
    std::size_t& best = longest.at(placed[i].line.p1(), 8 * placed[i].kind + eighthOf(placed[i].line));
    if (best == none || lengthOf(placed[i]) > lengthOf(placed[best])) best = i;
  }
  std::vector<bool> wanted(placed.size());
  longest.addTo(wanted);
  return chosen(placed, wanted);
}

}  // namespace alidade::ui
