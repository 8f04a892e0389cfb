"""The studio's data other than jobs: scenes, uploaded pictures, answers of studies."""
