#include <algorithm>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/statement/gap.h"
#include "core/wording/gap_shares.h"

namespace alidade {

Statement gapWhere(const std::vector<GapShare>& where) {
  constexpr double least = 0.01;
  Statement statement{
      .id = "where",
      .title = Phrase::of("Where the gap lies"),
      .columns = {{"by", "", Statement::Column::Role::Name}, {"parts", "", Statement::Column::Role::Word}},
      .rows = {}};
  for (auto first = where.begin(); first != where.end();) {
    const auto end =
        std::find_if(first, where.end(), [&](const GapShare& share) { return share.by != first->by; });
    std::vector<std::string> parts;
    for (auto share = first; share != end; ++share)
      if (share->share >= least)
        parts.push_back(visibleText(partName(*share)) + " (" + displayText(100 * share->share, 0) + " %)");
    if (end - first > 1 && !parts.empty())
      //: a division of the readings and its parts: "belongs to: guideway (80 %), noise (20 %)"
      statement.sentences.push_back(Phrase::of("%1: %2", divisionName(*first), listed(parts)));
    first = end;
  }
  return statement;
}

}  // namespace alidade
