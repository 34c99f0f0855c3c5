#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

class QPainter;

namespace alidade::ui {

/// What is drawn on the pages of a report, and where else a page might begin. Lengths in mm from the top of
/// the text area.
class ReportPages {
 public:
  using Drawing = std::function<void(QPainter&)>;
  /// A drawing, and how much lower it stands than it was drawn.
  struct Placed {
    Drawing drawing;
    double lower = 0;
  };
  /// The head of a table, as drawn once, to be drawn again where the table goes on.
  struct Head {
    std::vector<Placed> drawings;
    double top = 0, height = 0;
  };
  using SharedHead = std::shared_ptr<const Head>;
  enum class Before {
    Section,  ///< a heading
    Text,     ///< anything else
  };
  /// Drawings on the last page so far, to tell of a head.
  struct Mark {
    std::size_t drawings = 0;
    double y = 0;
  };

  static constexpr double sectionGap = 2.8;  ///< mm above a heading that does not begin a page

  std::size_t count() const { return m_pages.size(); }
  const std::vector<Placed>& drawings(std::size_t page) const { return m_pages[page].drawings; }
  /// Where the drawings of the last page end, once it is `balance`d.
  double lastEnd() const { return m_pages.back().end; }

  /// A further page, where the one before is drawn on down to `end`.
  void add(double end);
  void draw(Drawing drawing) { m_pages.back().drawings.push_back({std::move(drawing)}); }
  /// A page might begin at `y` of the last page, with `head` where that is in a table.
  void mayBreak(double y, Before before, SharedHead head = {});
  Mark mark(double y) const { return {m_pages.back().drawings.size(), y}; }
  /// What was drawn on the last page since then, down to `y`.
  SharedHead headSince(const Mark& mark, double y) const;
  /// The last page begins with the head of a table that goes on.
  void beginsWith(SharedHead head) { m_pages.back().carried = std::move(head); }
  /// All is drawn, on the last page down to `y`: where that is less than `least`, what stands before it moves
  /// to the last page too, from a place where a page might begin, as long as there is room for it in
  /// `height`.
  void balance(double y, double least, double height);

 private:
  struct Break {
    std::size_t drawing = 0;  ///< the first of the next page
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
