#include "app/console/guidance_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/console/text_layout.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"
#include "core/statement/next_measures.h"
#include "core/statement/sighting_choice.h"
#include "core/wording/guidance.h"
#include "core/wording/position_name.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string pointingText(Angle angle, CircleUnit unit) {
  return formatCircleReading(angle, unit, 0);
}

std::string nextText(const Guidance& guidance, CircleUnit unit) {
  if (!guidance.progress.next) return "\nNothing is left of the protocol.\n";
  const std::size_t next = *guidance.progress.next;
  std::string text = "\nNext: " + sightingNameInSession(guidance.progress.sightings[next].planned);
  if (const auto& expected = guidance.expected[next])
    text += ", about " + pointingText(expected->horizontal, unit) + " and " +
            pointingText(expected->vertical, unit);
  return text + "\n";
}

/// The sightings that are left or missed: the first six in a table, then the number of the others.
std::string leftText(const Guidance& guidance, CircleUnit unit) {
  constexpr std::size_t most = 6;
  Rows rows;
  std::size_t more = 0;
  const auto add = [&](std::size_t i) {
    const FollowedSighting& followed = guidance.progress.sightings[i];
    if (followed.state != SightingState::Left && followed.state != SightingState::Missed) return;
    if (rows.size() == most) return void(++more);
    std::vector<std::string> row{"  " + sightingNameInSession(followed.planned),
                                 followed.state == SightingState::Missed ? stateName(followed.state) : ""};
    if (const auto& expected = guidance.expected[i]) {
      row.push_back(pointingText(expected->horizontal, unit));
      row.push_back(pointingText(expected->vertical, unit));
    }
    rows.push_back(std::move(row));
  };
  const std::size_t count = guidance.progress.sightings.size(), next = guidance.progress.next.value_or(0);
  for (std::size_t i = 0; i < count; ++i) add((next + i) % count);
  if (rows.empty()) return "";
  std::string text = "\nThen\n" + alignedColumns(rows);
  if (more > 0) text += "  and " + std::to_string(more) + " more\n";
  return text;
}

std::string repeatsText(const Guidance& guidance) {
  if (guidance.allToRepeat.empty()) return "";
  std::string text = "\nTake again\n";
  for (const SightingsToRepeat& toRepeat : guidance.allToRepeat)
    text += paragraph("  " + repeatSentence(toRepeat, guidance.progress), 4);
  return text;
}

std::string joinedSentences(const std::string& first, const std::string& then) {
  return first.empty() ? then : first + " " + then;
}

}  // namespace

std::string guidanceText(const std::string& session, const Guidance& guidance, CircleUnit unit) {
  std::string text = heading(session) + "\n";
  text += paragraph("Protocol " +
                    (guidance.protocol.name.empty() ? "of its own" : quotation(guidance.protocol.name)) +
                    ": " + protocolInWords(guidance.protocol) + ". " + progressSentences(guidance.progress));
  const std::string choice =
      guidance.choice ? statementText(sightingChoiceStatement(*guidance.choice, guidance.progress)) : "";
  const std::string ahead =
      guidance.ahead ? statementText(sightingsAheadStatement(*guidance.ahead, *guidance.uncertainty)) : "";
  if (guidance.choice) return text + nextText(guidance, unit) + choice + ahead + repeatsText(guidance);
  return text + nextText(guidance, unit) + leftText(guidance, unit) + repeatsText(guidance) + "\n" +
         paragraph(joinedSentences(repeatsFirst(guidance.allToRepeat),
                                   outlookSentences(guidance.outlook, guidance.progress))) +
         statementText(insteadStatement(guidance.outlook));
}

}  // namespace alidade::console
