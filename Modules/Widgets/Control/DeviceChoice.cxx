#include "DeviceChoice.h"

#include "OpenBuiltInDevice.h"

#include <QMap>

namespace palpate
{
namespace
{
// What a person calls a device; one with an argument has no other name.
const QMap<QString, QString>& DeviceNames()
{
  static const QMap<QString, QString> names{
      {"simulated", "Mouse (no device)"},    {"falcon", "Novint Falcon"},
      {"inverse3", "Haply Inverse3"},        {"openhaptics", "3D Systems Touch"},
      {"forcedimension", "Force Dimension"}, {"controller", "Game controller"},
      {"spacemouse", "SpaceMouse"}};
  return names;
}

QString LabelOf(const std::string& device)
{
  const QString word = QString::fromStdString(device);
  return DeviceNames().value(word, word);
}
} // namespace

DeviceChoice::DeviceChoice(QWidget* parent) : QComboBox(parent)
{
  DeviceRegistry registry;
  if (RegisterBuiltInDevices(registry).IsOk())
  {
    for (const DeviceRegistry::Kind& kind : registry.Kinds())
    {
      this->addItem(LabelOf(kind.Name));
    }
  }
  this->setEditable(true);
}

void DeviceChoice::Choose(const std::string& device)
{
  this->setCurrentText(LabelOf(device));
}

std::string DeviceChoice::Chosen() const
{
  return DeviceNames().key(this->currentText(), this->currentText()).toStdString();
}
} // namespace palpate
