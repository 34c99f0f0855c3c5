#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

class QPainter;

namespace alidade::ui {

/// The drawings on a report's pages, and possible page breaks. Lengths in mm from the top of the text area.
class ReportPages {
 public:
  using Drawing = std::function<void(QPainter&)>;
  /// A drawing, and the distance in mm by which the drawing is moved down when it is painted.
  struct Placed {
    Drawing drawing;
    double lower = 0;
  };
  /// The head of a table, recorded once to be repeated where the table continues.
  struct Head {
    std::vector<Placed> drawings;
    double top = 0, height = 0;
  };
  using SharedHead = std::shared_ptr<const Head>;
  enum class Before {
    Section,  ///< a heading
    Text,     ///< anything else
  };
  /// Marks where a head begins: the number of drawings before it on the last page, and its upper end `y`.
  struct Mark {
    std::size_t drawings = 0;
    double y = 0;
  };

  static constexpr double sectionGap = 2.8;  ///< mm above a heading, except at the top of a page

  std::size_t count() const { return m_pages.size(); }
  const std::vector<Placed>& drawings(std::size_t page) const { return m_pages[page].drawings; }
  /// The lower end of the drawings on the last page, after `balance`.
  double lastEnd() const { return m_pages.back().end; }

  /// Adds a page. The drawings of the previous page end at `end`.
  void add(double end);
  void draw(Drawing drawing) { m_pages.back().drawings.push_back({std::move(drawing)}); }
  /// Allows a page break at `y` of the last page. `head`: the head of the table around the break; null: none.
  void mayBreak(double y, Before before, SharedHead head = {});
  Mark mark(double y) const { return {m_pages.back().drawings.size(), y}; }
  /// The head made of the last page's drawings since `mark`; `y`: lower end of the head.
  SharedHead headSince(const Mark& mark, double y) const;
  /// Records that the last page begins with `head`, already drawn, of a continued table.
  void beginsWith(SharedHead head) { m_pages.back().carried = std::move(head); }
  /// Called after all drawing; `y`: lower end of the last page. If `y` < `least`, moves the drawings after an
  /// allowed break of the previous page to the last page; the break is chosen so that all fit into `height`.
  void balance(double y, double least, double height);

 private:
  struct Break {
    std::size_t drawing = 0;  ///< the first drawing of the next page
    double y = 0;
    Before before = Before::Text;
    SharedHead head;
  };
  struct Page {
    std::vector<Placed> drawings;
    std::vector<Break> breaks;
    double end = 0;
    SharedHead carried;
    bool beginsWithSection = false;
  };

  double carriedHeight() const;
  double pulledHeight(const Break& at) const;
  const Break* bestBreak(double least, double height) const;
  void pullFrom(const Break& at);

  std::vector<Page> m_pages = std::vector<Page>(1);
};

}  // namespace alidade::ui
