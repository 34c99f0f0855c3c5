#include "core/certificate/administrative_data.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/phrase.h"
#include "core/base/sha256.h"
#include "core/base/visible_text.h"
#include "core/certificate/quantity.h"
#include "core/session/entry.h"
#include "core/wording/findings.h"

namespace alidade {

namespace {

std::string notStatedText() {
  return Phrase::of("not stated");
}

/// ISO 3166-1 reserves ZZ for private use.
constexpr const char* noCountry = "ZZ";

constexpr std::array<std::string_view, 5> placesOfPerformance = {"laboratory", "customer", "laboratoryBranch",
                                                                 "customerBranch", "other"};

Problem noDay(const std::string& text, const std::string& field) {
  if (text.empty())
    return Problem{
        Phrase::of(
            "is empty: a calibration certificate states the day of the measurement, such as 2026-03-01"),
        Place{.field = field}};
  return Problem{Phrase::of("%1 is no date: write it in the form 2026-03-01", quotation(text)),
                 Place{.field = field}};
}

bool isDay(const std::string& text) {
  return !text.empty() && !dateProblem(text);
}

/// Converts entries to texts of the certificate, and records the nouns of those that are empty.
class Statement {
 public:
  explicit Statement(StatedEntries& entries) : m_entries(entries) {}

  std::string of(const std::string& text, const char* noun) {
    std::string own = certificateText(text);
    if (own.empty()) m_entries.notStated.push_back(noun);
    return own;
  }

 private:
  StatedEntries& m_entries;
};

std::optional<Problem> takeDays(StatedEntries& stated, const CertificateSource& source,
                                const CertificateOptions& options) {
  const std::string measured = certificateText(source.session.measuredOn);
  stated.begin = measured.empty() ? options.measuredOn : measured;
  if (!isDay(stated.begin)) return noDay(stated.begin, "measured_on");
  stated.end = stated.begin;
  if (!options.issued.empty() && !isDay(options.issued)) return noDay(options.issued, "issued");
  if (!options.issued.empty() && options.issued < stated.end)
    return Problem{
        Phrase::of("the certificate would be issued on %1, before the measurement on %2: check both days",
                   options.issued, stated.end)};
  return std::nullopt;
}

constexpr const char* placeNoun = PHRASE_LATER("Phrase", "place of performance");

bool isNotStated(const StatedEntries& stated, std::string_view noun) {
  return std::ranges::find(stated.notStated, noun) != stated.notStated.end();
}

std::optional<Problem> takeCountry(StatedEntries& stated, const std::string& text) {
  stated.country = Statement(stated).of(text, PHRASE_LATER("Phrase", "country"));
  const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (stated.country.empty()) stated.country = noCountry;
  if (stated.country.size() == 2 && std::ranges::all_of(stated.country, isCapital)) return std::nullopt;
  return Problem{Phrase::of("%1 is no country: enter its two-letter code of ISO 3166-1, such as DE or CN",
                            quotation(text))};
}

std::optional<Problem> takePlace(StatedEntries& stated, const std::string& text) {
  stated.performedAt = Statement(stated).of(text, placeNoun);
  if (stated.performedAt.empty()) stated.performedAt = "other";
  if (std::ranges::find(placesOfPerformance, stated.performedAt) != placesOfPerformance.end())
    return std::nullopt;
  return Problem{
      Phrase::of("%1 is no place of performance: choose laboratory, customer, laboratoryBranch, "
                 "customerBranch or other",
                 quotation(text))};
}

/// Adds a name without a language; an empty name as “not stated”.
void addName(const Element& to, const std::string& text) {
  if (text.empty())
    to.say("name", notStatedText);
  else
    to.typed("name", text);
}

void addContact(const Element& to, const char* element, const std::string& name, const std::string& address) {
  const Element contact = to.add(element);
  addName(contact, name);
  const Element location = contact.add("location");
  if (address.empty())
    location.say("further", notStatedText);
  else
    location.typed("further", address);
}

void addCoreData(const Element& to, const CertificateOptions& options,
                 const std::vector<CertificateLanguage>& languages, const StatedEntries& stated) {
  const Element core = to.add("coreData");
  core.value("countryCodeISO3166_1", stated.country);
  for (const CertificateLanguage& language : languages) core.value("usedLangCodeISO639_1", language.code);
  core.value("mandatoryLangCodeISO639_1", languages.front().code);
  core.value("uniqueIdentifier", stated.identifier);
  core.value("beginPerformanceDate", stated.begin);
  core.value("endPerformanceDate", stated.end);
  core.value("performanceLocation", stated.performedAt);
  if (!options.issued.empty()) core.value("issueDate", options.issued);
}

void addItems(const Element& to, const CertificateSource& source, const StatedEntries& stated) {
  const Element item = to.add("items").add("item");
  item.attribute("id", "guideway");
  if (stated.device.empty())
    item.say("name", [] { return Phrase::of("Rotatable arc guideway, name not stated"); });
  else
    item.typed("name", stated.device);
  addName(item.add("manufacturer"), stated.manufacturer);
  // The schema has no translations for the value of an identification.
  item.add("identifications")
      .identification(
          "manufacturer", stated.serial.empty() ? "not stated" : stated.serial,
          [] { return Phrase::of("Serial number"); }, "basic_serialNumber");
  const Session& session = source.session;
  const Measurement& measurement = source.answer.measurement;
  StatedQuantity radius{
      .id = "nominal_radius",
      .name = [] { return Phrase::of("Nominal radius R0, at the temperature of the measurement"); },
      .value = measurement.nominalRadius,
      .unit = "\\milli\\metre"};
  if (!session.geometry.sigmaRadiusMm.empty()) radius.uncertainty = typedUncertainty(measurement.sigmaRadius);
  addQuantity(item.add("itemQuantities"), radius, "itemQuantity");
}

void addPerson(const Element& list, const std::string& name, const char* role, bool isMainSigner) {
  const Element person = list.add("respPerson");
  addName(person.add("person"), name);
  person.value("role", role);
  person.value("mainSigner", isMainSigner ? "true" : "false");
}

void addStatement(const Element& list, const char* id, const Say& name, const Say& text) {
  const Element statement = list.add("statement");
  statement.attribute("id", id);
  statement.say("name", name);
  statement.say("declaration", text);
}

void addStatements(const Element& to, const CertificateSource& source, const StatedEntries& stated) {
  const Element list = to.add("statements");
  addStatement(
      list, "scope", [] { return Phrase::of("Scope"); },
      [] { return Phrase::of("The results relate only to the item measured."); });
  const auto addTyped = [&](const char* id, const Say& name, const std::string& text) {
    if (const std::string own = certificateText(text); !own.empty()) {
      const Element statement = list.add("statement");
      statement.attribute("id", id);
      statement.say("name", name);
      statement.typed("declaration", own);
    }
  };
  addTyped(
      "title", [] { return Phrase::of("Title"); }, source.session.title);
  addTyped(
      "place", [] { return Phrase::of("Place of the measurement"); }, source.session.place);
  addTyped(
      "notes", [] { return Phrase::of("Notes"); }, source.session.notes);
  if (stated.notStated.empty()) return;
  addStatement(
      list, "not_stated", [] { return Phrase::of("Not stated"); },
      [&] {
        std::string text = Phrase::of("The laboratory did not state: %1.", listedNouns(stated));
        if (stated.country == noCountry) text = inTurn(text, Phrase::of("Country ZZ means “not stated”."));
        if (isNotStated(stated, placeNoun))
          text = inTurn(text, Phrase::of("Place “other” means “not stated”."));
        return text;
      });
}

}  // namespace

Result<StatedEntries> statedEntries(const CertificateSource& source, const CertificateOptions& options) {
  const Session& session = source.session;
  StatedEntries stated;
  Statement statement(stated);
  if (auto problem = takeDays(stated, source, options)) return *std::move(problem);
  stated.identifier = statement.of(session.report.number, PHRASE_LATER("Phrase", "report number"));
  if (stated.identifier.empty()) stated.identifier = "urn:alidade:session:sha256:" + sha256(source.bytes);
  if (auto problem = takeCountry(stated, options.country)) return *std::move(problem);
  if (auto problem = takePlace(stated, options.performedAt)) return *std::move(problem);
  stated.device = statement.of(session.device.name, PHRASE_LATER("Phrase", "device"));
  stated.manufacturer = statement.of(options.manufacturer, PHRASE_LATER("Phrase", "maker of the device"));
  stated.serial = statement.of(session.device.serial, PHRASE_LATER("Phrase", "device serial number"));
  const auto [laboratory, laboratoryAddress] = nameAndAddress(certificateText(session.report.laboratory));
  stated.laboratory = statement.of(laboratory, PHRASE_LATER("Phrase", "laboratory"));
  stated.laboratoryAddress =
      statement.of(laboratoryAddress, PHRASE_LATER("Phrase", "address of the laboratory"));
  stated.operatorName = certificateText(session.operatorName);
  stated.authorisedBy = statement.of(session.report.authorisedBy, PHRASE_LATER("Phrase", "authorised by"));
  const auto [customer, customerAddress] = nameAndAddress(certificateText(session.report.customer));
  stated.customer = statement.of(customer, PHRASE_LATER("Phrase", "customer"));
  stated.customerAddress = statement.of(customerAddress, PHRASE_LATER("Phrase", "address of the customer"));
  return stated;
}

void addSoftware(const Element& to, const char* list, const std::string& version) {
  const Element software = to.add(list).add("software");
  software.typed("name", "Alidade");
  software.value("release", version);
  software.value("type", "application");
}

void addAdministrativeData(const Element& certificate, const CertificateSource& source,
                           const CertificateOptions& options,
                           const std::vector<CertificateLanguage>& languages, const StatedEntries& stated) {
  const Element data = certificate.add("administrativeData");
  addSoftware(data, "dccSoftware", options.version);
  addCoreData(data, options, languages, stated);
  addItems(data, source, stated);
  addContact(data.add("calibrationLaboratory"), "contact", stated.laboratory, stated.laboratoryAddress);
  const Element persons = data.add("respPersons");
  addPerson(persons, stated.authorisedBy, "authorises", true);
  if (!stated.operatorName.empty()) addPerson(persons, stated.operatorName, "operator", false);
  addContact(data, "customer", stated.customer, stated.customerAddress);
  addStatements(data, source, stated);
}

}  // namespace alidade
