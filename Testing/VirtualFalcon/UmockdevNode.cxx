#include "UmockdevNode.h"

#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace palpate::test
{
namespace
{
// Null if the program has ended meanwhile.
ObjectPointer<UMockdevIoctlData> Resolve(UMockdevIoctlData* data, std::size_t offset,
                                         std::size_t size)
{
  return ObjectPointer<UMockdevIoctlData>(
      size > 0 ? umockdev_ioctl_data_resolve(data, offset, size, nullptr) : nullptr);
}

template <typename Structure>
Structure* As(const ObjectPointer<UMockdevIoctlData>& data)
{
  return data != nullptr ? reinterpret_cast<Structure*>(data->data) : nullptr;
}

void* AddressIn(const UMockdevIoctlData* argument)
{
  return *reinterpret_cast<void* const*>(argument->data);
}
} // namespace

// The handler is attached before the node exists, since a waiting program opens the node as soon as
// it appears.
UmockdevNode::UmockdevNode(UMockdevTestbed* bed, UsbfsFalcon& falcon, std::string path)
    : Bed(bed), Falcon(falcon), Path(std::move(path)), Handler(umockdev_ioctl_base_new())
{
  this->Self->Node = this;
  this->Connect("handle-ioctl", G_CALLBACK(OnRequest));
  this->Connect("client-connected", G_CALLBACK(OnConnected));
  const std::unique_ptr<gchar, decltype(&g_free)> root(umockdev_testbed_get_root_dir(bed), g_free);
  this->Pipe = root.get() + this->Path;
  std::filesystem::create_directories(std::filesystem::path(this->Pipe).parent_path());
  constexpr mode_t ForAll = 0666;
  if (umockdev_testbed_attach_ioctl(bed, this->Path.c_str(), this->Handler.get(), nullptr) == 0 ||
      mkfifo(this->Pipe.c_str(), ForAll) != 0)
  {
    throw std::runtime_error("the test bed gives no node");
  }
  this->Descriptor = open(this->Pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  fcntl(this->Descriptor, F_SETPIPE_SZ, 1); // rounded up to a page, which is one slot
  static_cast<void>(!write(this->Descriptor, "", 1));
}

// GLib releases the handler's reference to the handle once no handler runs any more.
void UmockdevNode::Connect(const char* signal, GCallback handler)
{
  g_signal_connect_data(
      this->Handler.get(), signal, handler, new std::shared_ptr<Handle>(this->Self),
      [](gpointer share, GClosure*) { delete static_cast<std::shared_ptr<Handle>*>(share); },
      GConnectFlags(0));
}

void UmockdevNode::Remove()
{
  if (!this->IsRemoved)
  {
    umockdev_testbed_detach_ioctl(this->Bed, this->Path.c_str(), nullptr);
    std::filesystem::remove(this->Pipe);
    this->IsRemoved = true;
  }
}

UmockdevNode::~UmockdevNode()
{
  this->Remove();
  const std::lock_guard<std::mutex> lock(this->Self->Access);
  this->Self->Node = nullptr;
  for (auto& [id, client] : this->Clients)
  {
    this->Falcon.CloseFile(client.File);
  }
  close(this->Descriptor);
}

void UmockdevNode::Show(Client& client, bool hasWork)
{
  const int before = this->WithWork;
  this->WithWork += static_cast<int>(hasWork) - static_cast<int>(client.HasWork);
  client.HasWork = hasWork;
  char byte = 0;
  if (before == 0 && this->WithWork > 0)
  {
    static_cast<void>(!read(this->Descriptor, &byte, 1));
  }
  else if (before > 0 && this->WithWork == 0)
  {
    static_cast<void>(!write(this->Descriptor, &byte, 1));
  }
}

UmockdevNode::Client& UmockdevNode::ClientOf(UMockdevIoctlClient* id)
{
  const auto [place, isNew] = this->Clients.try_emplace(id);
  Client& client = place->second;
  if (isNew)
  {
    client.File = this->Falcon.OpenFile(
        [this, &client](bool hasWork) { this->Show(client, hasWork); }, [] {});
  }
  return client;
}

// A new program's object may have the address of one that has ended, of which umockdev says nothing
// (its signal client-vanished is never sent): the new one must not get what the old one left.
void UmockdevNode::OnConnected(UMockdevIoctlBase*, UMockdevIoctlClient* id, gpointer handle)
{
  const std::shared_ptr<Handle> share = *static_cast<std::shared_ptr<Handle>*>(handle);
  const std::lock_guard<std::mutex> lock(share->Access);
  if (share->Node != nullptr)
  {
    share->Node->Forget(id);
  }
}

void UmockdevNode::Forget(UMockdevIoctlClient* id)
{
  const auto found = this->Clients.find(id);
  if (found != this->Clients.end())
  {
    this->Falcon.CloseFile(found->second.File);
    this->Falcon.WithFalcon([&](VirtualFalcon&) { this->Show(found->second, false); });
    this->Clients.erase(found);
  }
}

gboolean UmockdevNode::OnRequest(UMockdevIoctlBase*, UMockdevIoctlClient* id, gpointer handle)
{
  const std::shared_ptr<Handle> share = *static_cast<std::shared_ptr<Handle>*>(handle);
  const std::lock_guard<std::mutex> lock(share->Access);
  Client* const client = share->Node != nullptr ? &share->Node->ClientOf(id) : nullptr;
  const int answer = client != nullptr && client->File != nullptr
                         ? share->Node->Answer(*client, umockdev_ioctl_client_get_request(id),
                                               umockdev_ioctl_client_get_arg(id))
                         : -ENODEV;
  umockdev_ioctl_client_complete(id, answer < 0 ? -1 : answer, answer < 0 ? -answer : 0);
  return TRUE;
}

int UmockdevNode::Answer(Client& client, unsigned long request, UMockdevIoctlData* argument)
{
  switch (request)
  {
  case USBDEVFS_SUBMITURB:
    return this->Submit(client, argument);
  case USBDEVFS_REAPURBNDELAY:
    return this->Reap(client, argument);
  case USBDEVFS_DISCARDURB:
    return this->Falcon.Discard(*client.File, AddressIn(argument));
  default:
    break;
  }
  const auto structure = Resolve(argument, 0, _IOC_SIZE(request));
  if (structure == nullptr && _IOC_SIZE(request) > 0)
  {
    return -EFAULT;
  }
  ObjectPointer<UMockdevIoctlData> inner;
  if (request == USBDEVFS_CONTROL)
  {
    inner = Resolve(structure.get(), offsetof(usbdevfs_ctrltransfer, data),
                    As<usbdevfs_ctrltransfer>(structure)->wLength);
  }
  return this->Falcon.Answer(*client.File, request, As<void>(structure));
}

int UmockdevNode::Submit(Client& client, UMockdevIoctlData* argument)
{
  void* const address = AddressIn(argument);
  Submitted submitted;
  submitted.Urb = Resolve(argument, 0, sizeof(usbdevfs_urb));
  auto* const urb = As<usbdevfs_urb>(submitted.Urb);
  if (urb == nullptr)
  {
    return -EFAULT;
  }
  submitted.Buffer = Resolve(submitted.Urb.get(), offsetof(usbdevfs_urb, buffer),
                             static_cast<std::size_t>(urb->buffer_length));
  if (submitted.Buffer == nullptr && urb->buffer_length > 0)
  {
    return -EFAULT;
  }
  // Stored first: it may finish at once.
  client.Urbs[address] = std::move(submitted);
  const int answer = this->Falcon.Submit(*client.File, *urb, address);
  if (answer < 0)
  {
    client.Urbs.erase(address);
  }
  return answer;
}

int UmockdevNode::Reap(Client& client, UMockdevIoctlData* argument)
{
  void* address = nullptr;
  const int answer = this->Falcon.Reap(*client.File, address);
  if (answer < 0)
  {
    return answer;
  }
  const auto found = client.Urbs.find(address);
  const auto place = Resolve(argument, 0, sizeof(void*));
  if (place != nullptr)
  {
    umockdev_ioctl_data_set_ptr(place.get(), 0, found->second.Urb.get());
  }
  client.Urbs.erase(found);
  return place != nullptr ? 0 : -EFAULT;
}
} // namespace palpate::test
