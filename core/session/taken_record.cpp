#include "core/session/taken_record.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/other_circle.h"

namespace alidade {

namespace {

constexpr std::string_view beforeSource = ": ";

bool isOfSameNumber(const KnownSize& a, const KnownSize& b) {
  return a.effect == b.effect && a.parameter == b.parameter && a.unit == b.unit;
}

bool isTakenFrom(const NamedRecord& record, const KnownSize& size) {
  return !record.file.empty() && size.from.starts_with(citationOf(record));
}

void takeUnlessEmpty(std::string& own, const std::string& text) {
  if (!text.empty()) own = text;
}

void takeWhereEmpty(std::string& own, const std::string& text) {
  if (own.empty()) own = text;
}

/// The size as in the record's file, without the citation of the record.
KnownSize withoutCitation(KnownSize size, const NamedRecord& record) {
  if (!isTakenFrom(record, size)) return size;
  size.from.erase(0, citationOf(record).size());
  if (size.from.starts_with(beforeSource)) size.from.erase(0, beforeSource.size());
  return size;
}

/// Takes the record's offset, even an empty one, if the record states an offset or a collimation, or if the
/// session has an earlier record: an offset must stay with the collimation of the same record.
void takeLineOfSight(Instrument& own, const InstrumentRecord& record) {
  const bool hasCollimation =
      std::ranges::any_of(record.known, [](const KnownSize& size) { return size.effect == "collimation"; });
  if (!record.lineOfSight.offsetMm.empty() || hasCollimation || !own.record.file.empty())
    own.lineOfSight = record.lineOfSight;
}

/// The sizes of the record's errors on the session's circle.
std::vector<KnownSize> knownOn(const std::string& sessionCircle, const InstrumentRecord& record) {
  const auto own = verticalCircleEntry(sessionCircle), other = verticalCircleEntry(record.verticalCircle);
  const bool isOther = !record.verticalCircle.empty() && own && other && *own != *other;
  return isOther ? onOtherCircle(record.known) : record.known;
}

}  // namespace

std::string citationOf(const NamedRecord& record) {
  std::string citation = "instrument record " + record.file;
  if (!record.date.empty()) citation += " of " + record.date;
  return citation;
}

std::optional<Problem> takeRecord(Session& session, const InstrumentRecord& record, const std::string& file) {
  Instrument& own = session.instrument;
  if (!own.serial.empty() && !record.serial.empty() && own.serial != record.serial)
    //: two serial numbers in quotation marks
    return Problem{Phrase::of("%1 is not the serial number in the instrument record (%2): choose the record "
                              "of this instrument, or correct the serial number",
                              quotation(own.serial), quotation(record.serial)),
                   {.field = "instrument.serial"}};
  takeWhereEmpty(own.name, record.name);
  takeWhereEmpty(own.serial, record.serial);
  takeWhereEmpty(own.certificate, record.certificate);
  takeWhereEmpty(own.traceability, record.traceability);
  takeUnlessEmpty(own.sigmaHorizontalArcsec, record.sigmaHorizontalArcsec);
  takeUnlessEmpty(own.sigmaVerticalArcsec, record.sigmaVerticalArcsec);
  takeUnlessEmpty(own.sigmaZeroArcsec, record.sigmaZeroArcsec);
  takeLineOfSight(own, record);
  std::erase_if(own.known, [&](const KnownSize& size) {
    return isTakenFrom(own.record, size) || std::ranges::any_of(record.known, [&](const KnownSize& taken) {
             return isOfSameNumber(size, taken);
           });
  });
  own.record.file = file;
  own.record.date = record.date;
  for (KnownSize& size : knownOn(session.geometry.verticalCircle, record)) {
    size.from =
        citationOf(own.record) + (size.from.empty() ? "" : std::string(beforeSource)) + std::move(size.from);
    takeWhereEmpty(size.date, record.date);
    own.known.push_back(std::move(size));
  }
  return std::nullopt;
}

InstrumentRecord recordOf(const Session& session) {
  const Instrument& own = session.instrument;
  const auto circle = verticalCircleEntry(session.geometry.verticalCircle);
  InstrumentRecord record{.name = own.name,
                          .serial = own.serial,
                          .certificate = own.certificate,
                          .traceability = own.traceability,
                          .date = own.record.date.empty() ? session.measuredOn : own.record.date,
                          .verticalCircle = circle ? keyOf(*circle) : "",
                          .sigmaHorizontalArcsec = own.sigmaHorizontalArcsec,
                          .sigmaVerticalArcsec = own.sigmaVerticalArcsec,
                          .sigmaZeroArcsec = own.sigmaZeroArcsec,
                          .lineOfSight = own.lineOfSight};
  for (const KnownSize& size : own.known) record.known.push_back(withoutCitation(size, own.record));
  return record;
}

}  // namespace alidade
