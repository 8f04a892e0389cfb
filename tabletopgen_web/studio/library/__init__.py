"""The studio's data other than jobs: scenes, uploaded pictures, and answers to studies."""
