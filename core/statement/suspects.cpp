#include "core/statement/reliability.h"

#include "core/base/phrase.h"
#include "core/wording/suspects.h"

namespace alidade {

Statement suspectTable(const std::vector<Suspect>& suspects) {
  using Role = Statement::Column::Role;
  Statement statement{.id = "suspects",
                      .title = Phrase::of("Readings that look misread"),
                      .columns = {{"reading", "", Role::Name},
                                  {"deviation", Phrase::of("deviation"), Role::Word},
                                  {"intention", Phrase::of("probably meant"), Role::Remark}},
                      .rows = {}};
  constexpr std::size_t most = 40;
  for (const Suspect& suspect : suspects) {
    if (&suspect == suspects.data() + most) break;
    statement.rows.push_back({{nameOf(suspect), faultOf(suspect), intentionOf(suspect)}});
    for (std::size_t i = 1; i < suspect.proposals.size() && !suspect.isMasked; ++i)
      statement.rows.push_back(
          {.cells = {Phrase::of("or"), "", sentenceOf(suspect.proposals[i])}, .isPart = true});
  }
  if (suspects.size() > most)
    statement.sentences.push_back(Phrase::of("And %1 more.", suspects.size() - most));
  return statement;
}

}  // namespace alidade
