#include "ui/charts/plotting/row_choice.h"

#include <QCoreApplication>
#include <QMenu>
#include <algorithm>

#include "core/session/face.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

struct RowMenuText {
  Q_DECLARE_TR_FUNCTIONS(RowMenuText)
};

constexpr std::size_t mostListed = 50;

void addNumbers(QMenu& menu, const QString& all, const std::function<QString(int)>& one,
                const std::vector<int>& numbers, std::optional<int> chosen,
                const std::function<void(std::optional<int>)>& choose) {
  addChoice(menu, all, !chosen, [choose] { choose({}); });
  for (std::size_t i = 0; i < std::min(numbers.size(), mostListed); ++i)
    addChoice(menu, one(numbers[i]), chosen == numbers[i], [choose, number = numbers[i]] { choose(number); });
  if (numbers.size() > mostListed)
    menu.addAction(RowMenuText::tr("and %1 further").arg(numbers.size() - mostListed))->setEnabled(false);
}

}  // namespace

QAction* addChoice(QMenu& menu, const QString& text, bool isChosen, const std::function<void()>& choose) {
  QAction* action = menu.addAction(text);
  action->setCheckable(true);
  action->setChecked(isChosen);
  QObject::connect(action, &QAction::triggered, action, choose);
  return action;
}

void addRowChoices(QMenu& menu, const RowKinds& kinds, const RowChoice& choice,
                   const std::function<void(const RowChoice&)>& choose) {
  if (kinds.rounds.size() > 1)
    addNumbers(
        *menu.addMenu(RowMenuText::tr("&Rounds")), RowMenuText::tr("All Rounds"),
        [](int round) { return RowMenuText::tr("Round %1").arg(round); }, kinds.rounds, choice.round,
        [choice, choose](std::optional<int> round) {
          choose({round, choice.face});
        });
  if (kinds.faces.size() > 1)
    addNumbers(
        *menu.addMenu(RowMenuText::tr("&Faces")), RowMenuText::tr("Both Faces"),
        [](int face) { return capitalised(qText(faceName(face))); }, kinds.faces, choice.face,
        [choice, choose](std::optional<int> face) {
          choose({choice.round, face});
        });
}

}  // namespace alidade::ui
