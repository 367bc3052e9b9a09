#pragma once

#include <QComboBox>

#include <string>

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
};
} // namespace palpate
