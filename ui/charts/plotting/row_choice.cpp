#include "ui/charts/plotting/row_choice.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "core/session/face.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

struct RowChoiceText {
  Q_DECLARE_TR_FUNCTIONS(RowChoiceText)
};

constexpr double apart = 5, widest = 24;  // in units of `PlotStyle::unit`

void insert(std::vector<int>& sorted, int value) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (at == sorted.end() || *at != value) sorted.insert(at, value);
}

std::size_t rank(const std::vector<int>& sorted, int value) {
  // Needs no search in the usual case that rounds are numbered without gaps.
  const auto counted = static_cast<std::size_t>(value) - static_cast<std::size_t>(sorted.front());
  if (counted < sorted.size() && sorted[counted] == value) return counted;
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

std::optional<int> ifThere(std::optional<int> wanted, const std::vector<int>& sorted) {
  return wanted && std::binary_search(sorted.begin(), sorted.end(), *wanted) ? wanted : std::nullopt;
}

}  // namespace

void RowKinds::add(int round, int face) {
  if (rounds.empty() || rounds.back() != round) insert(rounds, round);
  if (faces.empty() || faces.back() != face) insert(faces, face);
}

RowChoice RowChoice::among(const RowKinds& kinds) const {
  return {.round = ifThere(round, kinds.rounds), .face = ifThere(face, kinds.faces)};
}

QString RowChoice::text() const {
  QStringList only;
  if (round) only.append(RowChoiceText::tr("round %1").arg(*round));
  if (face) only.append(qText(faceName(*face)));
  return only.isEmpty() ? QString() : RowChoiceText::tr("only %1").arg(listText(only));
}

RowSlots::RowSlots(const RowKinds& kinds, const RowChoice& choice)
    : m_rounds(choice.round ? std::vector{*choice.round} : kinds.rounds),
      m_faces(choice.face ? std::vector{*choice.face} : kinds.faces),
      m_count(std::max<std::size_t>(1, m_rounds.size() * m_faces.size())) {}

double RowSlots::shift(int round, int face) const {
  if (m_count < 2) return 0;
  const auto last = static_cast<double>(m_count - 1);
  const auto slot = static_cast<double>(rank(m_rounds, round) * m_faces.size() + rank(m_faces, face));
  return (slot - last / 2) * std::min(apart, widest / last);
}

}  // namespace alidade::ui
