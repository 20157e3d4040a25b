// Skins positions and normals as Sinew's kernel does: it blends the rows of the matrices of a
// vertex, applies them to the point, and their cofactors to the normal, which is made unit.
//
// skin INPUT OUTPUT COUNT reads the body and runs COUNT times. It prints the milliseconds of one
// run, and writes the positions, then the normals.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

typedef float Row __attribute__((vector_size(16)));

template <class T> std::vector<T> read(FILE *file, size_t count) {
  std::vector<T> values(count);
  if (fread(values.data(), sizeof(T), count, file) != count) exit(1);
  return values;
}

struct Body {
  uint32_t vertexCount, entryCount, influenceCount;
  std::vector<float> positions, normals, palette, weights;
  std::vector<uint32_t> start;
  std::vector<uint16_t> entries;
};

Body readBody(const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file) exit(1);
  const auto counts = read<uint32_t>(file, 3);
  Body body{counts[0], counts[1], counts[2]};
  body.positions = read<float>(file, body.vertexCount * 3);
  body.normals = read<float>(file, body.vertexCount * 3);
  body.palette = read<float>(file, body.entryCount * 12);
  body.start = read<uint32_t>(file, body.vertexCount + 1);
  body.weights = read<float>(file, body.influenceCount);
  body.entries = read<uint16_t>(file, body.influenceCount);
  fclose(file);
  return body;
}

void skin(const Body &body, const std::vector<Row> &rows, float *positions, float *normals) {
  for (uint32_t v = 0; v < body.vertexCount; v++) {
    Row a{}, b{}, c{};
    for (uint32_t i = body.start[v]; i < body.start[v + 1]; i++) {
      const Row *entry = &rows[body.entries[i] * 3];
      const float weight = body.weights[i];
      a += weight * entry[0];
      b += weight * entry[1];
      c += weight * entry[2];
    }
    const float *p = &body.positions[v * 3];
    positions[v * 3] = a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + a[3];
    positions[v * 3 + 1] = b[0] * p[0] + b[1] * p[1] + b[2] * p[2] + b[3];
    positions[v * 3 + 2] = c[0] * p[0] + c[1] * p[1] + c[2] * p[2] + c[3];
    const float *n = &body.normals[v * 3];
    const Row u{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    const Row w{c[1] * a[2] - c[2] * a[1], c[2] * a[0] - c[0] * a[2], c[0] * a[1] - c[1] * a[0]};
    const Row t{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const float sign = a[0] * u[0] + a[1] * u[1] + a[2] * u[2] < 0 ? -1.0f : 1.0f;
    const float x = u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
    const float y = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    const float z = t[0] * n[0] + t[1] * n[1] + t[2] * n[2];
    const float scale = sign / std::sqrt(x * x + y * y + z * z);
    normals[v * 3] = x * scale;
    normals[v * 3 + 1] = y * scale;
    normals[v * 3 + 2] = z * scale;
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 4) return 1;
  const Body body = readBody(argv[1]);
  std::vector<Row> rows(body.entryCount * 3);
  for (size_t i = 0; i < rows.size(); i++)
    for (int k = 0; k < 4; k++) rows[i][k] = body.palette[i * 4 + k];
  std::vector<float> out(body.vertexCount * 6);
  float *normals = out.data() + body.vertexCount * 3;
  skin(body, rows, out.data(), normals);
  const int count = atoi(argv[3]);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < count; i++) skin(body, rows, out.data(), normals);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  printf("%.6f\n", time.count() / count);
  FILE *file = fopen(argv[2], "wb");
  if (!file || fwrite(out.data(), 4, out.size(), file) != out.size()) return 1;
  return fclose(file);
}
