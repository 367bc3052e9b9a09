#include "Inverse3Messages.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::json;

constexpr double MetersToMillimeters = 1000.0;

// Null for what is not there.
const Json& Part(const Json& json, const char* name)
{
  static const Json null;
  const auto found = json.is_object() ? json.find(name) : json.end();
  return found != json.end() ? *found : null;
}

std::optional<double> Number(const Json& json)
{
  const double number = json.is_number() ? json.get<double>() : std::nan("");
  return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

// From the service's frame, which is turned about x.
Vector3 Turned(const Vector3& service)
{
  return {service.x(), service.z(), -service.y()};
}

std::optional<Vector3> VectorOf(const Json& json)
{
  const auto x = Number(Part(json, "x"));
  const auto y = Number(Part(json, "y"));
  const auto z = Number(Part(json, "z"));
  return x && y && z ? std::optional<Vector3>(Turned({*x, *y, *z})) : std::nullopt;
}

std::optional<Eigen::Quaterniond> OrientationOf(const Json& json)
{
  constexpr double MostFromUnit = 0.1;
  const auto w = Number(Part(json, "w"));
  const auto axis = VectorOf(json);
  if (!w || !axis)
  {
    return std::nullopt;
  }
  const Eigen::Quaterniond turn(*w, axis->x(), axis->y(), axis->z());
  return std::abs(turn.norm() - 1.0) < MostFromUnit
             ? std::optional<Eigen::Quaterniond>(turn.normalized())
             : std::nullopt;
}

const Json* DeviceIn(const Json& message, const char* kind, const std::string& id)
{
  const Json& devices = Part(message, kind);
  if (devices.is_array())
  {
    for (const Json& device : devices)
    {
      const Json& name = Part(device, "device_id");
      if (name.is_string() && (id.empty() || name == id))
      {
        return &device;
      }
    }
  }
  return nullptr;
}

// The grip in the hand: by cable or radio.
void TakeGrip(const Json& message, Inverse3Frame& frame)
{
  for (const char* kind : {"wireless_verse_grip", "verse_grip"})
  {
    if (const Json* const grip = DeviceIn(message, kind, ""))
    {
      const Json& state = Part(*grip, "state");
      const Json& buttons = Part(state, "buttons");
      std::uint32_t bit = 1;
      for (const char* button : {"a", "b", "c"})
      {
        frame.Buttons |= Part(buttons, button) == true ? bit : 0;
        bit <<= 1;
      }
      frame.Orientation = OrientationOf(Part(state, "orientation"));
      return;
    }
  }
}
} // namespace

std::optional<Inverse3Frame> ReadInverse3Frame(std::string_view text, const std::string& id)
{
  const Json message = Json::parse(text, nullptr, false);
  const Json* const device = DeviceIn(message, "inverse3", id);
  if (device == nullptr)
  {
    return std::nullopt;
  }
  const Json& config = Part(*device, "config");
  const Json& state = Part(*device, "state");
  Inverse3Frame frame;
  frame.Id = Part(*device, "device_id").get<std::string>();
  frame.IsFull = config.is_object();
  frame.HasPresets = Part(config, "preset").is_string();
  frame.IsSmall = Part(config, "type") == "minverse";
  frame.IsIdle = Part(state, "control_mode") == "idle";
  if (const auto position = VectorOf(Part(state, "cursor_position")))
  {
    frame.Position = MetersToMillimeters * *position;
  }
  frame.Displayed = VectorOf(Part(state, "current_cursor_force")).value_or(Vector3::Zero());
  TakeGrip(message, frame);
  return frame;
}

std::string Inverse3ForceMessage(const std::string& id, const Vector3& force, bool asVector,
                                 bool isFirst, bool hasPresets)
{
  Json device;
  device["device_id"] = id;
  Json& wanted = device["commands"]["set_cursor_force"][asVector ? "vector" : "values"];
  wanted["x"] = force.x();
  wanted["y"] = -force.z();
  wanted["z"] = force.y();
  Json message;
  if (isFirst)
  {
    message["session"]["configure"]["profile"]["name"] = "palpate";
    if (hasPresets)
    {
      device["configure"]["preset"] = "arm_front_centered";
    }
  }
  message["inverse3"].push_back(std::move(device));
  return message.dump();
}

std::optional<std::string> Inverse3Alarm(std::string_view text, const std::string& id)
{
  const Json event = Json::parse(text, nullptr, false);
  const Json& name = Part(event, "name");
  const Json& data = Part(event, "data");
  const Json& of = Part(data, "device_id");
  if (!name.is_string() || (of.is_string() && of != id))
  {
    return std::nullopt;
  }
  const Json& level = Part(event, "level");
  const bool isWarning = level != "info" && level != "notice";
  const Json& said = Part(event, "message");
  const std::string details = said.is_string() ? " (" + said.get<std::string>() + ")" : "";
  if (name == "device-safety-triggered" && isWarning)
  {
    return "The Inverse3 has stopped itself" + details + ": see to the device, then open it again.";
  }
  if (name == "device-disconnected" || name == "device-connection-loop")
  {
    return "The Inverse3 was lost" + details + ": check its cable, then open it again.";
  }
  if (name == "device-busy")
  {
    return "Another program uses the Inverse3" + details +
           ", and forces of two programs add up: end it, then open the device again.";
  }
  return std::nullopt;
}
} // namespace palpate
