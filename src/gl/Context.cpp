#include "gl/Context.h"

#include <epoxy/egl.h>
#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Api.h"
#include "gl/Bindings.h"
#include "gl/CurrentContext.h"

namespace limpid::gl {

struct Context::Egl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::string platform;

    ~Egl() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

namespace {

std::vector<EGLDeviceEXT> queryDevices() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base"))
        return {};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    eglQueryDevicesEXT(count, devices.data(), &count);
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

bool deviceHas(EGLDeviceEXT device, std::string_view extension) {
    const char* all = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return all && std::string_view(all).find(extension) != std::string_view::npos;
}

DeviceDescription describe(EGLDeviceEXT device, int index) {
    DeviceDescription description{index, "device", deviceHas(device, "EGL_MESA_device_software")};
    if (description.software) description.name = "software";
    if (deviceHas(device, "EGL_EXT_device_drm"))
        if (const char* file = eglQueryDeviceStringEXT(device, EGL_DRM_DEVICE_FILE_EXT))
            description.name = file;
    return description;
}

std::string listOf(const std::vector<DeviceDescription>& devices) {
    std::string list;
    for (const auto& device : devices)
        list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", device.index, device.name);
    return list.empty() ? "none" : list;
}

bool matches(const DeviceDescription& device, const std::string& wanted) {
    if (wanted.empty()) return true;
    if (wanted.find_first_not_of("0123456789") == std::string::npos)
        return std::to_string(device.index) == wanted;
    return device.name.find(wanted) != std::string::npos;
}

/// Hardware first; what the user asked for alone, if anything.
std::vector<int> candidates(const std::vector<DeviceDescription>& devices, const std::string& wanted) {
    std::vector<int> order;
    for (const bool software : {false, true})
        for (const auto& device : devices)
            if (device.software == software && matches(device, wanted)) order.push_back(device.index);
    return order;
}

/// `robust`: requireContext is to be told of a reset.
EGLContext createContext(EGLDisplay display, bool debug, bool robust) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) return EGL_NO_CONTEXT;
    const EGLint configAttributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, configAttributes, &config, 1, &count) || count == 0)
        config = EGL_NO_CONFIG_KHR;
    std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION,       4,
                                      EGL_CONTEXT_MINOR_VERSION,       5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_CONTEXT_OPENGL_DEBUG,        debug ? EGL_TRUE : EGL_FALSE};
    if (robust)
        attributes.insert(attributes.end(),
                          {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

bool open(EGLDisplay display, bool debug, EGLDisplay& openedDisplay, EGLContext& openedContext) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) return false;
    EGLContext context = EGL_NO_CONTEXT;
    if (epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness"))
        context = createContext(display, debug, true);
    if (context == EGL_NO_CONTEXT) context = createContext(display, debug, false); // some name it and refuse
    if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        openedDisplay = display;
        openedContext = context;
        return true;
    }
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    return false;
}

void GLAPIENTRY onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                               const GLchar* text, const void* user) {
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    if (type == GL_DEBUG_TYPE_PERFORMANCE) return;
    const auto& sink = *static_cast<const std::function<void(const std::string&)>*>(user);
    const std::string message(text, static_cast<std::size_t>(length));
    if (sink)
        sink(message);
    else
        fmt::print(stderr, "OpenGL: {}\n", message);
}

std::string glString(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

/// What the shaders ask of a driver beyond what OpenGL 4.5 guarantees.
void requireLimits(const DeviceInfo& info) {
    struct Limit {
        GLenum name;
        int least;
        const char* what;
    };
    constexpr Limit limits[] = {
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, bufferBindings, "bindings of storage buffers"},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, computeBuffers, "storage buffers in a compute shader"},
        {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, fragmentBuffers, "storage buffers in a fragment shader"},
        {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, vertexBuffers, "storage buffers in a vertex shader"},
        {GL_MAX_GEOMETRY_SHADER_STORAGE_BLOCKS, geometryBuffers, "storage buffers in a geometry shader"}};
    for (const Limit& limit : limits) {
        GLint found = 0;
        glGetIntegerv(limit.name, &found);
        if (found < limit.least)
            throw GraphicsError(fmt::format("OpenGL: expected at least {} {}, found {} by {}", limit.least,
                                            limit.what, found, info.renderer));
    }
}

DeviceInfo queryInfo(EGLDisplay display, const std::string& platform) {
    DeviceInfo info;
    info.vendor = glString(GL_VENDOR);
    info.renderer = glString(GL_RENDERER);
    info.version = glString(GL_VERSION);
    info.glsl = glString(GL_SHADING_LANGUAGE_VERSION);
    const char* egl = display == EGL_NO_DISPLAY ? nullptr : eglQueryString(display, EGL_VERSION);
    info.egl = egl ? egl : "";
    info.platform = platform;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.maxTextureSize);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &info.maxTextureLayers);
    glGetIntegerv(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, &info.maxComputeInvocations);
    glGetIntegerv(GL_SUBPIXEL_BITS, &info.subpixelBits);
    GLint64 storage = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
    info.maxStorageBlockBytes = storage;
    return info;
}

} // namespace

std::string softwareWord(std::span<const DeviceDescription> devices, std::string_view platform) {
    if (platform != "surfaceless" && !platform.ends_with("(software)")) return {};
    std::vector<DeviceDescription> hardware;
    std::copy_if(devices.begin(), devices.end(), std::back_inserter(hardware),
                 [](const DeviceDescription& device) { return !device.software; });
    if (hardware.empty()) return {};
    return fmt::format("OpenGL: expected to open {}, found no OpenGL 4.5 there: in software from here on",
                       listOf(hardware));
}

std::vector<DeviceDescription> Context::devices() {
    std::vector<DeviceDescription> described;
    for (const EGLDeviceEXT device : queryDevices())
        described.push_back(describe(device, int(described.size())));
    return described;
}

Context::Context(const ContextOptions& options)
    : _egl(std::make_unique<Egl>()), _onMessage(options.onMessage) {
    const auto devices = queryDevices();
    const auto described = Context::devices();
    const auto order = candidates(described, options.device);
    if (!options.device.empty() && order.empty())
        throw GraphicsError(fmt::format("EGL: expected a device named or numbered \"{}\", found {}",
                                        options.device, listOf(described)));
    for (const int index : order) {
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(index)], nullptr);
        if (!open(display, options.debug, _egl->display, _egl->context)) continue;
        _egl->platform = fmt::format("device {} ({})", index, described[std::size_t(index)].name);
        break;
    }
    if (_egl->context == EGL_NO_CONTEXT && options.device.empty() &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (open(display, options.debug, _egl->display, _egl->context)) _egl->platform = "surfaceless";
    }
    if (_egl->context == EGL_NO_CONTEXT)
        throw GraphicsError(fmt::format("EGL: expected a device with OpenGL 4.5 core, found {} without it",
                                        listOf(described)));
    glDisable(GL_DITHER); // the same bits with every driver
    if (const std::string word = softwareWord(described, _egl->platform);
        !word.empty() && options.device.empty())
        _onMessage ? _onMessage(word) : fmt::print(stderr, "{}\n", word);
    listenAndQuery(options, _egl->platform);
}

Context::Context(Current, const ContextOptions& options)
    : _egl(std::make_unique<Egl>()), _onMessage(options.onMessage), _isHosts(true) {
    const std::optional<std::string> found = currentContext();
    if (!found) throw GraphicsError("OpenGL: expected a context that is current on this thread, found none");
    if (const int version = epoxy_gl_version(); version < 45 || !epoxy_is_desktop_gl())
        throw GraphicsError(fmt::format("expected a current context with OpenGL 4.5, found {} by {}",
                                        glString(GL_VERSION), glString(GL_RENDERER)));
    listenAndQuery(options, "window (" + *found + ")");
}

void Context::listenAndQuery(const ContextOptions& options, const std::string& platform) {
    _ledger.setLimit(options.memory);
    if (options.debug) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(onDebugMessage, &_onMessage);
    }
    _info = queryInfo(eglGetCurrentDisplay(), platform);
    requireLimits(_info);
}

Context::~Context() = default;

} // namespace limpid::gl
