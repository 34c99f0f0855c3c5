#include "ui/text/known_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/effects/known_sizes.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct Known {
  Q_DECLARE_TR_FUNCTIONS(Known)
};

constexpr int longestOfKnown = 40;  // characters

QString entryName(const KnownSize& size) {
  if (const EffectParameter* parameter = findParameter(size.effect, size.parameter, size.unit))
    return numberName(*effectById(size.effect), *parameter);
  QStringList parts;
  for (const std::string& part : {size.effect, size.parameter, size.unit})
    if (!part.empty()) parts.append(shortLine(part, longestOfKnown));
  return parts.isEmpty() ? Known::tr("an effect without a name") : listText(parts);
}

QString memberName(const std::string& member) {
  return member == "sigma" ? QStringLiteral("u") : qText(member);
}

}  // namespace

QString numberName(const Effect& effect, const EffectParameter& parameter) {
  return effectText({.effect = std::string(effect.id), .name = std::string(parameter.name), .unit = {}});
}

QString knownName(const Session& session, const KnownRow& row) {
  if (row.effect) return numberName(*row.effect, *row.parameter);
  const KnownSize* size = row.entry ? knownSize(session, *row.entry) : nullptr;
  return size ? entryName(*size) : QString();
}

QString knownText(const KnownSize& size) {
  QStringList parts{entryName(size)};
  if (!size.value.empty()) parts.append(qText(size.value));
  if (!size.sigma.empty()) parts.append(QStringLiteral("u ") + qText(size.sigma));
  if (!size.unit.empty()) parts.append(qText(size.unit));
  const QString what = parts.join(u' ');
  return size.from.empty() ? what : listText({what, qText(size.from)});
}

QString accessibleKnown(const Session& session, const KnownPlace& place) {
  const KnownSize* size = knownSize(session, place.ref);
  if (!size) return {};
  const QString accessible = Known::tr("known size of %1").arg(entryName(*size));
  return place.member.empty() ? accessible : listText({accessible, memberName(place.member)});
}

}  // namespace alidade::ui
