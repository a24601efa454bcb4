#include "idiophone/foundation/accelerator/accelerator.hpp"

#ifdef IDIOPHONE_HAS_OPENCL

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "opencl.hpp"

namespace idiophone::accelerator {

namespace {

constexpr std::size_t most_parcels = 64;  // more would only fill the queue

struct Found {
  cl_device_id id;
  std::string name;
  bool is_gpu;
};

/// @param ask  OpenCL's function that answers this question about the object
template <class Object, class Question>
std::string answer(cl_int (*ask)(Object, Question, std::size_t, void*, std::size_t*), Object object,
                   Question question) {
  std::size_t length = 0;
  require_success(ask(object, question, 0, nullptr, &length), "ask for its name");
  std::string text(length, '\0');
  require_success(ask(object, question, length, text.data(), nullptr), "ask for its name");
  text.resize(text.find('\0'));  // it ends with one
  return text;
}

void add_devices(cl_platform_id platform, std::vector<Found>& all) {
  cl_uint count = 0;
  if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS) {
    return;  // a driver without a device
  }
  std::vector<cl_device_id> devices(count);
  require_success(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, devices.data(), nullptr), "list the devices");
  const std::string driver = answer(&clGetPlatformInfo, platform, cl_platform_info{CL_PLATFORM_NAME});
  for (cl_device_id device : devices) {
    cl_device_type type = 0;
    require_success(clGetDeviceInfo(device, CL_DEVICE_TYPE, sizeof(type), &type, nullptr), "ask for its type");
    const std::string name = answer(&clGetDeviceInfo, device, cl_device_info{CL_DEVICE_NAME});
    all.push_back({device, fmt::format("{} ({})", name, driver), (type & CL_DEVICE_TYPE_GPU) != 0});
  }
}

std::vector<Found> all_devices() {
  cl_uint count = 0;
  if (clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS) {
    return {};  // no driver
  }
  std::vector<cl_platform_id> platforms(count);
  require_success(clGetPlatformIDs(count, platforms.data(), nullptr), "list the drivers");
  std::vector<Found> all;
  for (cl_platform_id platform : platforms) {
    add_devices(platform, all);
  }
  return all;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Drivers that do not know double precision refuse the question.
bool computes_in_doubles(cl_device_id device) {
  cl_device_fp_config doubles = 0;
  return clGetDeviceInfo(device, CL_DEVICE_DOUBLE_FP_CONFIG, sizeof(doubles), &doubles, nullptr) == CL_SUCCESS &&
         doubles != 0;
}

bool fits(const std::string& wish, std::size_t number, const Found& device) {
  if (wish == "gpu") {
    return device.is_gpu;
  }
  if (!wish.empty() && std::ranges::all_of(wish, [](unsigned char c) { return std::isdigit(c) != 0; })) {
    return wish == std::to_string(number);
  }
  return in_small_letters(device.name).find(in_small_letters(wish)) != std::string::npos;
}

std::string complaint(const std::string& wish, const std::vector<Found>& all) {
  if (all.empty()) {
    return "accelerator: OpenCL finds no device; install the driver of the graphics card (Debian: nvidia-opencl-icd, "
           "mesa-opencl-icd or intel-opencl-icd), or pocl-opencl-icd, which computes on the processor";
  }
  std::string text = fmt::format("accelerator: no device is '{}'; ", wish);
  text += wish == "gpu" ? "install the OpenCL driver of the graphics card, or choose one of these:" : "there are:";
  for (std::size_t number = 0; number < all.size(); ++number) {
    text += fmt::format("\n  {}: {}", number, all[number].name);
  }
  return text;
}

}  // namespace

Accelerator::Accelerator(const std::string& wish, int turn) {
  const std::vector<Found> all = all_devices();
  std::vector<Found> fitting;
  for (std::size_t number = 0; number < all.size(); ++number) {
    if (fits(wish, number, all[number])) {
      fitting.push_back(all[number]);
    }
  }
  if (fitting.empty()) {
    throw std::runtime_error(complaint(wish, all));
  }
  const Found& chosen = fitting[turn % fitting.size()];
  name_ = chosen.name;
  device_ = chosen.id;
  has_doubles_ = computes_in_doubles(chosen.id);
  cl_int status = CL_SUCCESS;
  context_ = owned(clCreateContext(nullptr, 1, &chosen.id, nullptr, nullptr, &status), &clReleaseContext);
  require_success(status, "open it");
  queue_ =
      owned(clCreateCommandQueue(static_cast<cl_context>(context()), chosen.id, 0, &status), &clReleaseCommandQueue);
  require_success(status, "make a queue");
}

void Accelerator::flush() {
  require_success(clFlush(static_cast<cl_command_queue>(queue())), "begin");
}

void Accelerator::keep(Handle arrived, std::vector<std::byte> bytes) {
  on_the_way_.push_back({std::move(arrived), std::move(bytes)});
  const auto has_arrived = [](const Parcel& parcel) {
    cl_int state = CL_QUEUED;
    require_success(clGetEventInfo(static_cast<cl_event>(parcel.arrived.get()), CL_EVENT_COMMAND_EXECUTION_STATUS,
                                   sizeof(state), &state, nullptr),
                    "ask whether data arrived");
    require_success(std::min(state, CL_COMPLETE), "receive data");  // below: an error
    return state == CL_COMPLETE;
  };
  if (on_the_way_.size() > most_parcels) {
    auto* const oldest = static_cast<cl_event>(on_the_way_.front().arrived.get());
    require_success(clWaitForEvents(1, &oldest), "wait for data");
  }
  while (!on_the_way_.empty() && has_arrived(on_the_way_.front())) {
    on_the_way_.pop_front();
  }
}

}  // namespace idiophone::accelerator

#endif
