#include "ui/report/report_pages.h"

#include <algorithm>
#include <utility>

namespace alidade::ui {

void ReportPages::add(double end) {
  m_pages.back().end = end;
  m_pages.emplace_back();
}

void ReportPages::mayBreak(double y, Before before, SharedHead head) {
  Page& page = m_pages.back();
  if (page.drawings.empty()) page.beginsWithSection = before == Before::Section;
  page.breaks.push_back({page.drawings.size(), y, before, std::move(head)});
}

ReportPages::SharedHead ReportPages::headSince(const Mark& mark, double y) const {
  const std::vector<Placed>& drawn = m_pages.back().drawings;
  return std::make_shared<const Head>(
      Head{{drawn.begin() + static_cast<std::ptrdiff_t>(mark.drawings), drawn.end()}, mark.y, y - mark.y});
}

double ReportPages::carriedHeight() const {
  const Page& last = m_pages.back();
  return last.carried ? last.carried->height : 0;
}

/// The lower end of the last page, mm, if the page began at this break.
double ReportPages::pulledHeight(const Break& at) const {
  const Page &last = m_pages.back(), &before = m_pages[m_pages.size() - 2];
  return (at.head ? at.head->height : 0) + before.end - at.y + last.end - carriedHeight() +
         (last.beginsWithSection ? sectionGap : 0);
}

/// The latest break that fills the last page enough, preferably before a section; null if no break does.
const ReportPages::Break* ReportPages::bestBreak(double least, double height) const {
  const Page& before = m_pages[m_pages.size() - 2];
  const double mostOfSection = 0.7 * height, leastLeft = height / 4;
  const Break* found = nullptr;
  for (auto at = before.breaks.rbegin(); at != before.breaks.rend(); ++at) {
    const double pulled = pulledHeight(*at);
    if (pulled > height || at->y < leastLeft) break;
    if (pulled < least) continue;
    if (at->before == Before::Section && pulled <= mostOfSection) return &*at;
    if (!found) found = &*at;
  }
  return found;
}

void ReportPages::pullFrom(const Break& at) {
  Page &last = m_pages.back(), &before = m_pages[m_pages.size() - 2];
  Page whole;
  double end = 0;
  const auto take = [&whole](auto first, auto past, double lower) {
    for (; first != past; ++first)
      whole.drawings.push_back({std::move(first->drawing), first->lower + lower});
  };
  if (at.head) {
    std::vector<Placed> head = at.head->drawings;
    take(head.begin(), head.end(), -at.head->top);
    end += at.head->height;
  }
  const auto first = before.drawings.begin() + static_cast<std::ptrdiff_t>(at.drawing);
  take(first, before.drawings.end(), end - at.y);
  end += before.end - at.y + (last.beginsWithSection ? sectionGap : 0);
  const double carried = carriedHeight();
  const std::size_t repeated = last.carried ? last.carried->drawings.size() : 0;
  take(last.drawings.begin() + static_cast<std::ptrdiff_t>(repeated), last.drawings.end(), end - carried);
  whole.end = end + last.end - carried;
  before.drawings.erase(first, before.drawings.end());
  before.end = at.y;
  last = std::move(whole);
}

void ReportPages::balance(double y, double least, double height) {
  m_pages.back().end = y;
  if (m_pages.size() < 2 || y >= least) return;
  if (const Break* at = bestBreak(least, height)) pullFrom(Break(*at));
}

}  // namespace alidade::ui
