#include "VirtualInverse3.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <set>
#include <sys/socket.h>
#include <thread>

namespace palpate::test
{
namespace
{
namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using Json = nlohmann::json;
using Socket = websocket::stream<asio::ip::tcp::socket>;
using Failed = boost::system::error_code;

Json VectorJson(const Vector3& v)
{
  return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}};
}

const char* EventOf(Inverse3Fault fault)
{
  switch (fault)
  {
  case Inverse3Fault::StopsItself:
    return R"({"name":"device-safety-triggered","category":"device","level":"error",
                 "data":{"device_id":"049D","safety_type":"ebrake_triggered"},"message":"brake"})";
  case Inverse3Fault::Unplugged:
    return R"({"name":"device-disconnected","category":"device","level":"warning",
                 "data":{"device_id":"049D"},"message":"lost"})";
  case Inverse3Fault::UsedByAnother:
    return R"({"name":"device-busy","category":"device","level":"warning",
                 "data":{"device_id":"049D"},"message":"in use"})";
  default:
    return nullptr;
  }
}
} // namespace

/// Two threads, one for each port; each serves one client after the other.
class VirtualInverse3::Server
{
public:
  Server(VirtualInverse3& owner, const Settings& settings)
      : Owner(owner), Given(settings), StateDoor(Context, Anywhere()),
        EventDoor(Context, Anywhere()),
        StateThread([this] { this->Serve(this->StateDoor, &Server::ServeStates); }),
        EventThread([this] { this->Serve(this->EventDoor, &Server::ServeEvents); })
  {
  }
  ~Server()
  {
    this->MustEnd = true;
    this->HangUp();
    // Accepting waits for a client.
    for (const auto* door : {&this->StateDoor, &this->EventDoor})
    {
      asio::ip::tcp::socket knock(this->Context);
      Failed ignored;
      knock.connect(door->local_endpoint(), ignored);
    }
    this->StateThread.join();
    this->EventThread.join();
  }
  int StatePort() const { return this->StateDoor.local_endpoint().port(); }
  int EventPort() const { return this->EventDoor.local_endpoint().port(); }

private:
  static asio::ip::tcp::endpoint Anywhere() { return {asio::ip::address_v4::loopback(), 0}; }

  // A client that stays would be waited for.
  void HangUp()
  {
    const std::lock_guard<std::mutex> lock(this->ClientGuard);
    for (const int client : this->Clients)
    {
      shutdown(client, SHUT_RDWR);
    }
  }

  void Serve(asio::ip::tcp::acceptor& door, void (Server::*serveOne)(Socket&))
  {
    while (!this->MustEnd)
    {
      Failed failed;
      Socket client(door.accept(failed));
      if (failed || this->MustEnd)
      {
        return;
      }
      client.next_layer().set_option(asio::ip::tcp::no_delay(true), failed);
      this->Note(client.next_layer().native_handle(), true);
      client.accept(failed);
      if (!failed)
      {
        (this->*serveOne)(client);
      }
      this->Note(client.next_layer().native_handle(), false);
    }
  }

  void Note(int client, bool isThere)
  {
    const std::lock_guard<std::mutex> lock(this->ClientGuard);
    isThere ? void(this->Clients.insert(client)) : void(this->Clients.erase(client));
    if (this->MustEnd)
    {
      shutdown(client, SHUT_RDWR);
    }
  }

  Json StateOf(const std::string& id, bool isFull)
  {
    Json device{{"device_id", id}};
    device["state"]["cursor_position"] = VectorJson(this->CursorNow());
    device["state"]["current_cursor_force"] = VectorJson(this->Force);
    device["state"]["control_mode"] = this->IsForced ? "force" : "idle";
    if (isFull)
    {
      device["config"]["type"] = this->Given.Type;
      if (this->Given.TakesVector)
      {
        device["config"]["preset"] = "defaults";
      }
    }
    return device;
  }
  Vector3 CursorNow()
  {
    const std::lock_guard<std::mutex> lock(this->Owner.Guard);
    const bool jumps = this->Owner.Broken == Inverse3Fault::Jump;
    return this->Owner.Cursor + Vector3(jumps ? 0.3 : 0.0, 0.0, 0.0);
  }
  std::string Message(bool isFull)
  {
    Json message{{"inverse3", Json::array()}};
    const Inverse3Fault fault = this->Owner.Broken;
    for (int n = 0; n < this->Given.DeviceCount && fault != Inverse3Fault::NoDevice; ++n)
    {
      const std::string id = n == 0 ? "049D" : "04A" + std::to_string(n);
      message["inverse3"].push_back(
          this->StateOf(fault == Inverse3Fault::WrongDevice ? "FFFF" : id, isFull));
    }
    if (fault == Inverse3Fault::NotANumber && !message["inverse3"].empty())
    {
      message["inverse3"][0]["state"]["cursor_position"]["x"] = nullptr;
    }
    if (this->Given.HasGrip)
    {
      message["wireless_verse_grip"][0] = {
          {"device_id", "61576"},
          {"state",
           {{"orientation", {{"w", 0.8}, {"x", 0.0}, {"y", 0.6}, {"z", 0.0}}},
            {"buttons", {{"a", false}, {"b", true}, {"c", false}}}}}};
    }
    const std::string text = message.dump();
    return fault == Inverse3Fault::HalfMessage ? text.substr(0, text.size() / 2) : text;
  }

  void Take(const std::string& text)
  {
    const Json message = Json::parse(text, nullptr, false);
    const Json& commands = message["inverse3"][0]["commands"]["set_cursor_force"];
    const char* const field = this->Given.TakesVector ? "vector" : "values";
    const std::lock_guard<std::mutex> lock(this->Owner.Guard);
    this->Owner.First = this->Owner.First.empty() ? text : this->Owner.First;
    this->IsForced = commands.contains(field);
    if (this->IsForced)
    {
      const Json& force = commands[field];
      this->Force =
          Vector3(force["x"].get<double>(), force["y"].get<double>(), force["z"].get<double>());
      this->Owner.Taken.push_back(this->Force);
    }
  }

  void ServeStates(Socket& client)
  {
    Failed failed;
    client.write(asio::buffer(this->Message(true)), failed);
    boost::beast::flat_buffer buffer;
    while (!failed)
    {
      client.read(buffer, failed);
      if (failed)
      {
        return;
      }
      this->Take(boost::beast::buffers_to_string(buffer.data()));
      buffer.consume(buffer.size());
      switch (this->Owner.Broken.load())
      {
      case Inverse3Fault::Silent:
        continue;
      case Inverse3Fault::Late:
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        break;
      case Inverse3Fault::CloseFrame:
        client.close(websocket::close_code::going_away, failed);
        return;
      case Inverse3Fault::CutOff:
        client.next_layer().close(failed);
        return;
      default:
        break;
      }
      client.binary(this->Owner.Broken == Inverse3Fault::Binary);
      client.write(asio::buffer(this->Owner.Broken == Inverse3Fault::Binary
                                    ? std::string(64, '\xff')
                                    : this->Message(false)),
                   failed);
    }
  }

  void ServeEvents(Socket& client)
  {
    Failed failed;
    bool isTold = false;
    while (!failed && !this->MustEnd)
    {
      const char* const event = EventOf(this->Owner.Broken);
      if (event != nullptr && !isTold)
      {
        client.write(asio::buffer(std::string(event)), failed);
        isTold = true;
      }
      // Ended by the client: a read of what never comes would tell, but waits.
      char byte = 0;
      client.next_layer().non_blocking(true, failed);
      client.next_layer().receive(asio::buffer(&byte, 1), asio::socket_base::message_peek, failed);
      failed = failed == asio::error::would_block ? Failed() : failed;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  VirtualInverse3& Owner;
  Settings Given;
  std::atomic<bool> MustEnd{false};
  std::mutex ClientGuard;
  std::set<int> Clients;
  Vector3 Force = Vector3::Zero();
  bool IsForced = false;
  asio::io_context Context;
  asio::ip::tcp::acceptor StateDoor;
  asio::ip::tcp::acceptor EventDoor;
  std::thread StateThread;
  std::thread EventThread;
};

VirtualInverse3::VirtualInverse3() : VirtualInverse3(Settings()) {}
VirtualInverse3::VirtualInverse3(const Settings& settings)
    : Running(std::make_unique<Server>(*this, settings))
{
}
VirtualInverse3::~VirtualInverse3() = default;

std::string VirtualInverse3::Argument() const
{
  return "port=" + std::to_string(this->Running->StatePort()) +
         ",events=" + std::to_string(this->Running->EventPort());
}
void VirtualInverse3::MoveTo(const Vector3& cursor)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Cursor = cursor;
}
std::vector<Vector3> VirtualInverse3::Forces() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Taken;
}
std::string VirtualInverse3::Handshake() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->First;
}
} // namespace palpate::test
