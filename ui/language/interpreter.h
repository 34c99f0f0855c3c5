#pragma once

#include <QTranslator>
#include <memory>
#include <vector>

namespace alidade::ui {

/// A language with its translations: those of the program, then those of Qt. English has none.
struct Tongue {
  QString id;
  std::vector<std::unique_ptr<QTranslator>> texts;
};

/// The language with this id; null: unsupported.
const Tongue* tongueOf(const QString& id);

/// Translates into the language of the calling thread.
class Interpreter : public QTranslator {
  Q_OBJECT

 public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override;

  /// `setTongue` sets the language of the program. `ownTongue` is the language set for the calling thread, or
  /// null; `tongue` is the language that the thread uses.
  static void setTongue(const Tongue* tongue);
  static const Tongue*& ownTongue();
  static const Tongue* tongue();
};

}  // namespace alidade::ui
