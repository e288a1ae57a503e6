// A compiler may contract a * b + c where nothing is `precise`, in one program and not in another. Where two
// programs promise the same bits, one of them is contracted here.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "engine/EngineFixture.h"
#include "gl/Contracted.h"
#include "io/TempFolder.h"
#include "scene/MethodFacts.h"

namespace limpid {
namespace {

/// While it lives, compute shaders with one of some words in their text are compiled by glslangValidator,
/// contracted, and given to the driver as SPIR-V.
class Contracting {
  public:
    explicit Contracting(std::vector<std::string> words)
        : _words(std::move(words)), _source(epoxy_glShaderSource), _compile(epoxy_glCompileShader) {
        self() = this;
        epoxy_glShaderSource = [](GLuint shader, GLsizei count, const GLchar* const* text,
                                  const GLint* length) {
            self()->_text = text[0];
            self()->_source(shader, count, text, length);
        };
        epoxy_glCompileShader = [](GLuint shader) { self()->compile(shader); };
    }
    ~Contracting() {
        epoxy_glShaderSource = _source;
        epoxy_glCompileShader = _compile;
    }
    Contracting(const Contracting&) = delete;
    Contracting& operator=(const Contracting&) = delete;

    int count() const { return _count; }

  private:
    void compile(GLuint shader) {
        const auto holds = [&](const std::string& word) { return _text.find(word) != std::string::npos; };
        if (!std::any_of(_words.begin(), _words.end(), holds) || !holds("local_size"))
            return _compile(shader);
        const std::string file = _folder.write("shader.comp", _text).string();
        const std::string command = fmt::format("glslangValidator -G {0} -o {0}.spv >{0}.txt", file);
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::ifstream stream(file + ".spv", std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
        gl::Contracted::Words module(bytes.size() / 4);
        std::memcpy(module.data(), bytes.data(), 4 * module.size());
        const gl::Contracted contracted(module);
        const gl::Contracted::Words words = contracted.words();
        glShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V, words.data(), GLsizei(4 * words.size()));
        glSpecializeShader(shader, "main", 0, nullptr, nullptr);
        _count += contracted.count();
    }
    static Contracting*& self() {
        static Contracting* one = nullptr;
        return one;
    }

    std::vector<std::string> _words;
    PFNGLSHADERSOURCEPROC _source;
    PFNGLCOMPILESHADERPROC _compile;
    std::string _text;
    test::TempFolder _folder;
    int _count = 0;
};

/// A method for each way to walk beams, both of which skip.
constexpr Method methods[] = {Method::LevelMap, Method::ExactBeam};

class ContractGLTest : public EngineGLTest {
  protected:
    static std::vector<Baked> bakes(Engine& engine) {
        std::vector<Baked> all;
        for (const Method method : methods) {
            Scene scene = scenes::floorPastSphere(25);
            scene.water.waves = {scenes::cosine(0.008, 0.35, {1, 0.4}), scenes::noise(0.02, 0.5)};
            scene.water.grid = {48, 48};
            scene.caustics.mapSize = 64;
            scene.caustics.planes = 8;
            scene.caustics.fill = Fill::OnePass;
            scene.caustics.method = method;
            all.push_back(bake(engine, scene));
        }
        return all;
    }
};

// Where work is skipped, tiles of beams are culled by their bounds, and the footprints of what is left are
// found by another program.
TEST_F(ContractGLTest, ofOneOfTwoProgramsChangesNoBitThatSkippingMustNot) {
    Engine working(context());
    working.setSkipping(false);
    const std::vector<Baked> all = bakes(working);
    const Contracting compiler({"#define TILES", "buffer Reached"});
    Engine skipping(context());
    const std::vector<Baked> less = bakes(skipping);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t m = 0; m < all[i].maps.size(); ++m)
            EXPECT_TRUE(less[i].maps[m].irradiance == all[i].maps[m].irradiance) << methodName(methods[i]);
    EXPECT_GT(compiler.count(), 0);
}

} // namespace
} // namespace limpid
