#pragma once

#include "DeviceList.h"

#include <QComboBox>

#include <string>
#include <vector>

namespace palpate
{
/// A choice of the built-in devices, by what people call them. Editable, for "name:argument".
class DeviceChoice : public QComboBox
{
  Q_OBJECT

public:
  explicit DeviceChoice(QWidget* parent);

  /// As DeviceRegistry::Make takes it.
  void Choose(const std::string& device);
  std::string Chosen() const;
  /// What a search found: each device has its line as a tool tip, and of several of a kind each can
  /// be chosen.
  void Show(const std::vector<DeviceReport>& found);

  void showPopup() override;

Q_SIGNALS:
  void Changed(); ///< another one is chosen; a name that is typed counts once it is complete
  void Opened();  ///< the list is about to be shown

private:
  void Take();

  bool IsTyped = false; ///< and not complete
};
} // namespace palpate
