#pragma once

#include "SceneSettings.h"

#include <QMenu>

#include <array>
#include <vector>

namespace palpate
{
/// The context menu of selected structures.
class StructureMenu : public QMenu
{
  Q_OBJECT

public:
  enum Entry
  {
    OnlyThis,
    Show,  ///< or hide
    Touch, ///< make touchable or untouchable
    Color,
    Opacity,
    Details,
    Guide, ///< the tool by this structure
    Rename,
    Centre,
    Check, ///< all masks
    Remove,
    EntryCount
  };

  explicit StructureMenu(QWidget* parent);

  /// Adapts the entries to the selected structures.
  void Offer(const std::vector<SceneStructure>& selected);
  QAction* ActionOf(Entry entry) const { return this->Entries.at(entry); }
  /// Whether Show shows, and not hides; whether Touch makes touchable.
  bool Shows() const { return this->AnyHidden; }
  bool Touches() const { return this->AnyUntouchable; }

Q_SIGNALS:
  void Chosen(int entry);

private:
  void Add(Entry entry, const QString& text, const QString& name);

  std::array<QAction*, EntryCount> Entries{};
  bool AnyHidden = false;
  bool AnyUntouchable = false;
};
} // namespace palpate
