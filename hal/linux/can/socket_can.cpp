#include "hal/linux/can/socket_can.hpp"

#include <errno.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/net_tstamp.h>
#include <net/if.h>
#include <sys/socket.h>
#include <time.h>

#include <cstring>

#include "hal/linux/can/can_frame_format.hpp"
#include "hal/linux/system/monotonic_clock.hpp"

namespace hal {
namespace {

constexpr uint64_t kReopenPeriod_ns = 100000000;

template <typename Value>
bool set_option(int socket, int level, int name, const Value& value) {
  return ::setsockopt(socket, level, name, &value, sizeof value) == 0;
}

std::string explain(const std::string& interface, int error) {
  switch (error) {
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
      return "this kernel has no CAN sockets (modules can and can-raw)";
    case ENODEV:
      return "there is no interface \"" + interface +
             "\", expected one of `ip link show`; for a virtual one: ip link add dev " + interface + " type vcan";
    case EOPNOTSUPP:
      return "interface \"" + interface + "\" carries no CAN FD frames, expected mtu 72 (ip link set " + interface +
             " mtu 72)";
    default:
      return "CAN interface \"" + interface + "\": " + std::strerror(error);
  }
}

}  // namespace

bool SocketCan::receive_only(const uint32_t* ids, size_t id_count) {
  if (id_count > kMaxFilters) return false;
  for (size_t i = 0; i < id_count; ++i) filters_[i] = {ids[i], CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
  filter_count_ = id_count;
  return true;
}

std::string SocketCan::open(const std::string& interface, const Options& options) {
  if (interface.empty() || interface.size() >= sizeof interface_)
    return "\"" + interface + "\" is no interface name, expected 1 to 15 characters such as can0";
  interface.copy(interface_, sizeof interface_ - 1);
  interface_[interface.size()] = '\0';
  options_ = options;
  counters_ = {};
  const int error = connect();
  return error == 0 ? "" : explain(interface, error);
}

bool SocketCan::configure(int socket) {
  const can_err_mask_t errors = options_.error_frames ? CAN_ERR_MASK : 0;
  const int on = 1, stamp = SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE;
  bool good = set_option(socket, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, errors);
  size_t filters = filter_count_;
  if (confirms()) {
    filters_[filters++] = {options_.confirmed_id, CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
    good &= set_option(socket, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, on);
  }
  if (filter_count_ > 0 || !options_.data_frames)
    good &= ::setsockopt(socket, SOL_CAN_RAW, CAN_RAW_FILTER, filters_,
                         static_cast<socklen_t>(filters * sizeof filters_[0])) == 0;
  if (options_.fd) good &= set_option(socket, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, on);
  set_option(socket, SOL_SOCKET, SO_RCVBUF, options_.receive_buffer_bytes);
  set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, on);
  if (!set_option(socket, SOL_SOCKET, SO_TIMESTAMPING, stamp))
    good &= set_option(socket, SOL_SOCKET, SO_TIMESTAMPNS, on);
  return good;
}

int SocketCan::connect() {
  FileDescriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!socket) return errno;
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface_));
  if (address.can_ifindex == 0) return ENODEV;
  if (!configure(socket.get())) return errno == 0 ? EINVAL : errno;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return errno;
  socket_ = std::move(socket);
  overflow_before_ += counters_.receive_overflow;
  counters_.receive_overflow = 0;
  up_ = true;
  lost_ = false;
  in_flight_.dropped();
  return 0;
}

// Sorts a refusal of the kernel into what the controller has to know.
CanResult SocketCan::refused(int error) {
  switch (error) {
    case ENOBUFS:
    case EAGAIN:
      ++counters_.queue_full;
      return CanResult::kQueueFull;
    case ENODEV:
    case ENXIO:
    case EBADF:
      lost_ = true;
      [[fallthrough]];
    case ENETDOWN:
      in_flight_.dropped();
      if (up_) ++counters_.interface_down;
      up_ = false;
      return CanResult::kBusDown;
    default:
      ++counters_.faults;
      return CanResult::kFault;
  }
}

void SocketCan::reopen_if_due() {
  const uint64_t now_ns = read_clock_ns(CLOCK_MONOTONIC);
  if (now_ns < next_try_ns_) return;
  next_try_ns_ = now_ns + kReopenPeriod_ns;
  connect();  // until then it stays lost
}

CanResult SocketCan::send(const CanFrame& frame) {
  if (lost_) reopen_if_due();
  if (lost_) return CanResult::kBusDown;
  const bool confirmed = confirms() && frame.id == options_.confirmed_id && !frame.extended && !frame.error;
  if (confirmed && in_flight_.full()) return refused(ENOBUFS);
  const KernelCanFrame kernel = to_kernel(frame);
  const ssize_t written = ::send(socket_.get(), &kernel.frame, kernel.size, MSG_DONTWAIT | MSG_NOSIGNAL);
  if (written < 0) return refused(errno);
  if (confirmed) in_flight_.sent(read_clock_ns(CLOCK_MONOTONIC));
  up_ = true;
  ++counters_.sent;
  return CanResult::kDone;
}

// The time stamp of a received frame on the monotonic clock; 0 where the kernel gave none. Keeps the overflow count.
uint64_t SocketCan::read_control(const msghdr& message) {
  uint64_t time_ns = 0;
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(const_cast<msghdr*>(&message), part)) {
    if (part->cmsg_level != SOL_SOCKET) continue;
    if (part->cmsg_type == SO_TIMESTAMPING || part->cmsg_type == SO_TIMESTAMPNS) {
      timespec stamp{};  // the first of three for SO_TIMESTAMPING: software
      std::memcpy(&stamp, CMSG_DATA(part), sizeof stamp);
      if (stamp.tv_sec != 0 || stamp.tv_nsec != 0) time_ns = monotonic_from_time_of_day_ns(to_ns(stamp));
    } else if (part->cmsg_type == SO_RXQ_OVFL) {
      std::memcpy(&counters_.receive_overflow, CMSG_DATA(part), sizeof counters_.receive_overflow);
    }
  }
  return time_ns;
}

// What has come tells of the frames in flight.
void SocketCan::note_in_flight(const CanFrame& frame, bool from_this_machine) {
  if (frame.error && (frame.id & CAN_ERR_RESTARTED) != 0) in_flight_.dropped();
  if (!frame.error && !from_this_machine) in_flight_.bus_lives(frame.time_ns);
}

CanResult SocketCan::receive(CanFrame& frame) {
  if (lost_) reopen_if_due();
  if (lost_) return CanResult::kBusDown;
  for (;;) {
    bool own = false;
    const CanResult result = receive_any(frame, own);
    if (result != CanResult::kDone || !own) return result;
  }
}

CanResult SocketCan::receive_any(CanFrame& frame, bool& own) {
  canfd_frame kernel;
  alignas(cmsghdr) char control[256];
  iovec data{&kernel, sizeof kernel};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  const ssize_t size = ::recvmsg(socket_.get(), &message, MSG_DONTWAIT);
  if (size < 0) {
    if (errno == EAGAIN || errno == EINTR) return CanResult::kEmpty;
    return refused(errno);
  }
  own = (message.msg_flags & MSG_CONFIRM) != 0;
  if (own) {
    in_flight_.came_back();
    return CanResult::kDone;
  }
  if (!from_kernel(kernel, static_cast<size_t>(size), frame)) {
    ++counters_.faults;
    return CanResult::kFault;
  }
  frame.time_ns = read_control(message);
  if (frame.time_ns == 0) frame.time_ns = read_clock_ns(CLOCK_MONOTONIC);
  note_in_flight(frame, (message.msg_flags & MSG_DONTROUTE) != 0);
  up_ = true;
  ++(frame.error ? counters_.error_frames : counters_.received);
  return CanResult::kDone;
}

}  // namespace hal
